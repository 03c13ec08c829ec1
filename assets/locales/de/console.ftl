### Die Konsole, und das Zeichen der Welten, in denen ein Befehl benutzt wurde, der mogelt.

action-console = Konsole
action-workshop = Werkstatt: bauen oder gehen

console-entry = Befehl
console-hint = Ein Befehl; Tab ergänzt ihn, help nennt alle, Esc schließt
console-no-command = Es gibt keinen Befehl „{ $name }“. help nennt die, die es gibt.
console-refused = Das geht nicht: { $details }.
console-settled = Alles Land um dich ist da.
console-unsettled = { $count ->
    [one] Ein Stück Land entsteht noch.
   *[other] { $count } Stücke Land entstehen noch.
}
console-no-wait = Hier vergeht die Zeit von selbst; nur Skripte warten.
console-no-perf = Nur Skripte messen. Im Spiel sagen die Bildzeiten, was ein Bild braucht.
console-marked = Diese Welt ist von nun an gezeichnet: In ihr wurde ein Befehl benutzt, der mogelt.
console-saving = Die Welt wird gespeichert.
console-not-kept = Diese Welt hat keinen Namen und wird darum nicht aufgehoben.
console-open-already = „{ $name }“ ist schon offen.
console-no-worlds = Noch ist keine Welt gespeichert.
console-room-changed = Geändert. „room save“ behält es.
console-room-saved = Der Raum ist gespeichert.
console-no-versions = Es gibt keine älteren Fassungen dieses Raums.
console-world = { $name } ({ $space }, Startwert { $seed })
console-shot-name = Das Bild kommt nach { $dir }; gib ihm einen Namen ohne Ordner.

cheats-used = Gemogelt

console-help = Befehle: { $commands }. help BEFEHL sagt mehr zu einem.
console-help-new = Macht eine neue Welt und betritt sie; die jetzige wird vorher gespeichert.
console-help-load = Betritt eine gespeicherte Welt; die jetzige wird vorher gespeichert.
console-help-save = Speichert diese Welt jetzt.
console-help-delete = Löscht eine gespeicherte Welt für immer.
console-help-list = Nennt die gespeicherten Welten.
console-help-quit = Speichert diese Welt und beendet das Spiel.
console-help-hold = Hält eine Taste oder Maustaste einige Sekunden lang.
console-help-down = Drückt eine Taste und hält sie bis „up“.
console-help-up = Lässt eine Taste los.
console-help-tap = Drückt eine Taste und lässt sie los.
console-help-click = Drückt eine Maustaste und lässt sie los.
console-help-press = Drückt eine Maustaste und hält sie bis „release“.
console-help-release = Lässt eine Maustaste los.
console-help-look = Dreht den Blick wie die Maus, um Pixel nach rechts und unten.
console-help-aim = Richtet den Blick, in Grad: 0 entlang x, 90 entlang z; aufwärts positiv.
console-help-scroll = Dreht das Rad um Rasten.
console-help-wait = Lässt Zeit vergehen; nur in Skripten.
console-help-settle = Sagt, ob alles Land um dich da ist; ein Skript wartet darauf.
console-help-probe = Sagt den Zustand der Welt als eine Zeile JSON.
console-help-shot = Hebt ein Bild dessen, was du siehst, ohne Konsole im Ordner der Bildschirmfotos auf.
console-help-set = Ändert eine Einstellung dieser Welt oder eine deiner eigenen, wie auf dem Bildschirm der Einstellungen. time, health und fly on zeichnen die Welt.
console-help-give = Gibt dir Gegenstände, in einer Welt zum Sammeln auch Kubikmeter einer Bodenart. Zeichnet die Welt.
console-help-make = Stellt einen Gegenstand aus gesammeltem Boden her.
console-help-teleport = Versetzt dich anderswohin, in Metern der Karte. Zeichnet die Welt.
console-help-spawn = Stellt eine Figur, ein Auto, eine Lampe oder eine Fahne in die Welt.
console-help-name-flag = Gibt der Fahne, die dir am nächsten ist, einen Namen.
console-help-perf = Misst Bilder; nur in Skripten.
console-help-room = Macht, betritt, speichert, löscht oder nennt Räume verformten Raums und öffnet ältere Fassungen.
console-help-add = Stellt etwas in den offenen Raum.
console-help-change = Ändert etwas im offenen Raum.
console-help-remove = Nimmt etwas aus dem offenen Raum.
console-help-group = Macht im offenen Raum eine Gruppe, die ihre Mitglieder trägt.
console-help-carry = Lässt eine Gruppe Dinge tragen, oder keine.
console-help-ungroup = Nimmt Gruppen weg und lässt, was sie trugen.
console-help-duplicate = Verdoppelt Dinge im offenen Raum.
console-help-array = Kopiert Dinge in einer Reihe oder im Kreis.
console-help-undo = Nimmt die letzten Änderungen am offenen Raum zurück, in einer Welt die letzten Striche des Pinsels.
console-help-redo = Macht zurückgenommene Änderungen am Raum noch einmal.
console-help-help = Sagt etwas zu allen Befehlen oder zu einem.
