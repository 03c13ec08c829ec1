### Meldungen, Hinweise und was misslingen kann. { $path } ist eine Datei oder ein Ordner, { $details } sind englische Sätze.

saved = Gespeichert

hint-map-raised = Die angehobene Karte
hint-map-horizon = Die Horizontkarte
hint-no-other-map = Die Sphäre hat keine andere Karte.
hint-bent = { $up } biegt das Bild hyperbolisch, { $down } sphärisch.
hint-unbent = Das Bild ist wieder flach.
hint-no-bullets = Du hast keine Kugeln mehr.
hint-no-place-for-lamp = Eine Lampe braucht Boden, höchstens acht Meter entfernt.
hint-none-there-lamp = Unter dem Fadenkreuz ist keine Lampe.
hint-too-many-lamp = Diese Welt hat zu viele Lampen; hebe erst eine auf.
room-hint-no-place-for-lamp = Eine Lampe braucht etwas unter dem Fadenkreuz, worauf sie stehen kann, höchstens acht Meter entfernt.
room-hint-too-many-lamps = Dieser Raum hat selbst schon acht Lampen, und mehr können nicht leuchten.
room-hint-nothing-to-lift = Unter dem Fadenkreuz ist innerhalb von drei Metern nichts Loses.
room-hint-too-heavy = Das ist zu schwer zum Heben; schieb es.
room-hint-fell-out = Du bist aus dem Raum gefallen und beginnst von vorn.
room-hint-for-worlds = { $key } ist für Welten. In einem Raum sind Pistole, Lampen und Bälle immer zur Hand.
hint-no-place-for-flag = Eine Fahne braucht Boden, der nicht zu steil ist, höchstens acht Meter entfernt.
hint-none-there-flag = Unter dem Fadenkreuz ist keine Fahne.
hint-too-many-flag = Diese Welt hat zu viele Fahnen; nimm erst eine auf.
hint-no-place-for-log = Ein Baumstück braucht freien Boden zum Stehen, höchstens acht Meter entfernt.
hint-no-place-for-stone = Ein Stein braucht freien Boden zum Liegen, höchstens acht Meter entfernt.
hint-no-place-for-seed = Ein Samen braucht weichen, ebenen Boden unter freier Luft, einen Schritt von anderen Bäumen, höchstens acht Meter entfernt.
hint-no-place-for-crumb = Eine Brotkrume braucht Boden, höchstens acht Meter entfernt.
hint-none-there-crumb = Unter dem Fadenkreuz ist keine Brotkrume.
hint-last-crumb = Das war deine letzte Brotkrume: Hier endet deine Spur.
hint-too-many-crumb = In dieser Welt sind zu viele Brotkrumen; heb erst eine auf.
hint-moved-crumb = Du hast die erste Brotkrume aufgehoben und hier hingelegt: Eine Welt hat höchstens 512.
hint-none-there-log = Unter dem Fadenkreuz ist kein Baumstück.
hint-none-there-stone = Unter dem Fadenkreuz ist kein Stein.
hint-too-many-log = Diese Welt hat zu viele Baumstücke; nimm erst eines auf.
hint-too-many-stone = Diese Welt hat zu viele Steine; nimm erst einen auf.
hint-too-many-seed = Hier können keine Bäume mehr gepflanzt werden.
hint-no-place-for-door = Für die Tür ist kein Boden innerhalb von acht Metern.
hint-door-steep = Der Boden ist hier zu steil für eine Tür: suche eine ebene Stelle, oder grabe oder baue eine.
hint-door-walled = Hier ist Fels im Weg: eine Tür braucht vor und hinter sich einen Meter Platz.
hint-door-crowded = Die andere Tür ist zu nah: lass zweieinhalb Meter dazwischen.
against-door-steep = zu steil für eine Tür
against-door-walled = Fels im Weg
against-door-crowded = zu nah an der anderen Tür
hint-none-there-door = Unter dem Fadenkreuz ist keine Tür.
hint-too-many-door = Diese Welt hat ihre beiden Türen schon; nimm erst eine auf.
hint-moved-door = Die ältere Tür steht jetzt hier.
hint-no-room = Mehr kannst du nicht tragen.
hint-too-many-drops = Es liegt schon zu viel herum; hebe erst etwas auf.
hint-died-of-fall = Du bist zu tief gefallen. Du stehst am Anfang wieder auf.
hint-died-of-shot = Du wurdest erschossen. Du stehst am Anfang wieder auf.
hint-died-of-crash = Der Aufprall hat dich getötet. Du stehst am Anfang wieder auf.
hint-died-of-car = Ein Auto hat dich überfahren. Du stehst am Anfang wieder auf.
hint-died-of-tree = Ein Baum ist auf dich gefallen. Du stehst am Anfang wieder auf.
hint-no-car-near = Es ist kein Auto innerhalb von vier Metern zu sehen.
hint-look-at-car = Das Auto ist neben dir. Sieh es an, um einzusteigen.
hint-car-too-far = Das Auto ist zu weit weg zum Einsteigen. Geh näher heran.
hint-at-the-wheel = Am Steuer. Bremse: { $brake } · Kamera: { $camera } · Hupe: { $horn } · Aussteigen: { $leave }
hint-fallen-over = Das Auto ist umgekippt. { $flip } stellt es auf die Räder.
hint-no-way-out = Neben dem Auto ist kein freier Boden zum Aussteigen.
hint-back-again = Du bist wieder am Anfang. Was du getragen hast, ist noch bei dir.
hint-been-round = Du bist einmal um die ganze Welt gekommen, { $metres } m, und wieder da, wo du warst.
hint-nobody-to-talk-to = Vor dir ist niemand, mit dem du reden könntest.
hint-too-far-to-talk = Sie sind zu weit weg, um zu reden. Geh näher heran.
hint-waits-to-talk = Sie haben dich gehört und warten. Geh näher heran, um zu reden.
hint-in-the-way = Du stehst dem im Weg, was du baust, unter einer Decke. Geh zurück oder nimm einen kleineren Pinsel.
hint-out-of-reach = Nichts zum Graben ist in Reichweite. Geh näher heran.
hint-too-hard = Zu hart für diese Spitzhacke: { $kind }. Aus dem, was du abbaust, lässt sich eine bessere machen.
hint-nothing-to-build = Du hast keinen Boden zum Bauen. Grab zuerst welchen ab.
hint-used-up = Zum Bauen ist nichts mehr da: { $kind }. Wähle einen anderen Boden oder grab mehr ab.
hint-made = Hergestellt: { $item }
hint-no-coal-yet = Du hast tief gegraben und keine Kohle gefunden. Sie liegt in Flözen unter etwa der Hälfte des Landes: Grab dreißig Meter weiter oder sieh dir die Wände einer Höhle an.
hint-undone = Der letzte Strich ist zurückgenommen.
hint-undo-none-left = Es gibt keinen Strich mehr, der sich zurücknehmen lässt.
hint-undo-away = Der letzte Strich ist zu weit weg, um ihn zurückzunehmen. Geh dorthin zurück, wo du ihn gemacht hast.
hint-undo-changed = Der letzte Strich bleibt: Sein Boden wurde seitdem verändert.
hint-undo-spent = Der letzte Strich bleibt: Der Boden, den er gebracht hat, ist inzwischen verbraucht.
hint-undo-unreadable = Der letzte Strich bleibt: Was von seinem Boden gespeichert ist, lässt sich gerade nicht lesen. Sieh nach, ob der Datenträger da ist, und versuche es noch einmal.

talk-triangle-flat = Ich habe drei Lampen aufgestellt, jede { $side } m von den beiden anderen. Voneinander aus gesehen bilden sie zusammen { $sum }°, wie in der Schule.
talk-triangle-pictured = Ich habe drei Lampen aufgestellt, jede { $side } m von den beiden anderen. Voneinander aus gesehen bilden sie zusammen { $sum }°: Das Land ist flach, nur sein Bild ist gekrümmt.
talk-hello = Hallo! { $words }
talk-triangle-more = Ich habe drei Lampen aufgestellt, jede { $side } m von den beiden anderen. Voneinander aus gesehen bilden sie zusammen { $sum }°, mehr als 180.
talk-triangle-less = Ich habe drei Lampen aufgestellt, jede { $side } m von den anderen. Voneinander aus gesehen sind es zusammen { $sum }°, weniger als 180.
talk-horizon-lower = Siehst du den Boden { $away } m entfernt, so hoch wie hier? Er erscheint { $angle }° tiefer als in einem flachen Bild.
talk-horizon-flat = Siehst du den Boden { $away } m entfernt, so hoch wie hier? Er liegt genau da, wo ein flaches Bild ihn zeigt.
talk-horizon-higher = Siehst du den Boden { $away } m entfernt, so hoch wie hier? Er erscheint { $angle }° höher als in einem flachen Bild.
talk-home-round = Nach Hause sind es von hier { $there } m, oder { $round } m andersherum, um die ganze Welt.
talk-home-straight = Nach Hause sind es von hier { $there } m. Dieses Land hat kein Ende, also führt kein Weg herum.
talk-home-squares = Nach Hause sind es { $there } m, { $squares ->
    [0] noch in diesem Quadrat
    [one] { $squares } Quadrat weit
   *[other] { $squares } Quadrate weit
}. Jeder andere Weg ist länger, und die meisten sind viel länger.
talk-land = Im Umkreis von { $within } m gibt es auf dieser Höhe { $times }-mal so viel Land wie auf ebenem Grund. Weiter unten ist es mehr.
talk-square = Geh { $side } m, bieg rechts ab, und das viermal. Auf ebenem Grund wärst du zurück; hier stehst du { $gap } m von da, wo du losgegangen bist.

open-failed = Die Welt konnte nicht geöffnet werden
open-died = Beim Lesen ist etwas fehlgeschlagen; das Protokoll weiß mehr.
save-failed = Die Welt konnte nicht gespeichert werden
close-died = Beim Schreiben der Welt ist etwas fehlgeschlagen; das Protokoll weiß mehr.
not-saved = Die letzten Änderungen der Welt sind nicht gespeichert.
not-saved-yet = Die Welt konnte nicht gespeichert werden; das nächste Speichern versucht es wieder.
save-unfinished = Die letzte Änderung des Geländes oder ihr Speichern wurde nicht rechtzeitig fertig; alles früher Gespeicherte ist sicher.

save-in-use = Die Welt „{ $world }“ ist in Gebrauch: Sie ist in einem anderen Fenster des Spiels oder einem anderen Programm offen. Schließe sie dort und versuche es wieder.
save-newer = Die Welt „{ $world }“ wurde von einer neueren Version des Spiels gespeichert. Aktualisiere das Spiel, um sie zu spielen; es wurde nichts geändert.
save-damaged = Ein Teil dieser Welt ist beschädigt. Der Rest ist brauchbar; „antipode saves repair“ stellt eine ältere Kopie davon her, wenn es eine gibt. ({ $details })
save-part-damaged = Ein Teil dieser Welt ist beschädigt. Der Rest ist zu gebrauchen; „antipode saves verify“ sagt, was es ist, und „antipode saves repair“ stellt eine ältere Kopie wieder her, wenn es eine gibt.
save-unreadable = Der Spielstand { $path } ist beschädigt und nicht lesbar. „antipode saves repair“ rettet, was heil ist, und behält diese Datei.
save-file-missing = Die Datei { $path } dieser Welt fehlt. Wenn du eine Kopie hast, lege sie zurück; sonst macht „antipode saves repair“ die Welt neu, wo es geht.
save-vanished = Der Spielstand { $path } ist weg: Sein Ordner wurde verschoben, gelöscht oder ersetzt, während die Welt offen war, also kann dort nichts gespeichert werden. Lege den Ordner zurück und speichere wieder.
save-not-found = Die Welt „{ $world }“ gibt es nicht mehr.
saves-busy = Ein anderes Spiel erstellt, benennt oder importiert gerade eine Welt in { $path } und wird nicht fertig. Versuche es gleich noch einmal oder schließe das andere Spiel.
saves-not-a-folder = { $path } ist eine Datei, also kann sie keine Welten enthalten. Wähle einen Ordner mit --saves-dir.
file-exists = { $path } gibt es schon und wird nicht überschrieben. Wähle einen anderen Namen oder verschiebe es.
disk-full = Es ist kein Platz mehr, um { $path } zu schreiben. Schaffe Platz und speichere wieder; was früher gespeichert wurde, ist sicher.
not-writable = { $path } kann nicht geschrieben werden: Es ist schreibgeschützt oder gehört jemand anderem. Ändere die Rechte oder wähle mit --saves-dir einen anderen Ort.
not-readable = { $path } kann nicht gelesen werden: die Rechte verbieten es, oder es gehört jemand anderem. Ändere die Rechte oder wähle mit --saves-dir einen anderen Ort.
archive-refused = { $path } kann nicht importiert werden: es ist keine exportierte Welt, oder die Datei ist beschädigt. Im Protokoll steht mehr.
unknown-space = Die Welt „{ $world }“ liegt in einem Raum, den diese Version nicht kennt. Eine neuere Version des Spiels kann sie vielleicht öffnen.
unknown-generator = Das Land der Welt „{ $world }“ entsteht auf eine Weise, die diese Version nicht kennt. Eine neuere Version des Spiels kann sie vielleicht öffnen.
impossible-radius = Die Welt „{ $world }“ gibt an, ihr Raum habe einen Radius von { $radius } m; den kann keine Welt haben. Ihre Datei blieb, wie sie ist.
player-damaged = Der Spieler im Spielstand war beschädigt; du beginnst wieder am Anfang. Dein Land ist, wie es war.
unknown-item = Der Spielstand enthält einen Gegenstand, den diese Version nicht kennt („{ $item }“); er ist nicht zu sehen, bleibt aber im Spielstand.
unknown-records = { $count ->
    [one] Der Spielstand enthält ein Ding einer neueren Version; es ist nicht zu sehen, bleibt aber im Spielstand.
   *[other] Der Spielstand enthält { $count } Dinge einer neueren Version; sie sind nicht zu sehen, bleiben aber im Spielstand.
}
unknown-map = Der Spielstand nennt eine Karte, die diese Version nicht kennt („{ $map }“); eine andere wird gezeigt.
more-damaged = { $count ->
    [one] Eine weitere Stelle dieser Welt ist beschädigt; „antipode saves verify“ nennt sie.
   *[other] { $count } weitere Stellen dieser Welt sind beschädigt; „antipode saves verify“ nennt sie.
}
land-trouble = Mit dem Land stimmt etwas nicht. { $details }
other-trouble = Das hat nicht geklappt. { $details }

name-empty = Gib der Welt einen Namen.
name-blank = Der Name braucht mindestens ein sichtbares Zeichen.
name-too-long = { $chars ->
    [one] Der Name hat ein Zeichen; höchstens { $most } passen.
   *[other] Der Name hat { $chars } Zeichen; höchstens { $most } passen.
}
name-unprintable = Der Name enthält ein Zeichen, das nicht gezeigt werden kann ({ $code }).
name-taken = Es gibt schon eine Welt namens „{ $name }“.
room-name-taken = Es gibt schon einen Raum namens „{ $name }“.

no-adapter = Auf diesem Rechner wurde keine Grafikkarte gefunden, die das Spiel nutzen kann ({ $found }). Installiere ihren Treiber oder starte das Spiel mit --adapter software.
adapter-lost = Die Grafikkarte ist verloren gegangen. Deine Welt ist sicher; starte das Spiel neu.
adapter-refuses = Die Grafikkarte lehnt einen Shader des Spiels ab ({ $details }). Aktualisiere ihren Treiber oder starte das Spiel mit --adapter software.
adapter-reopened = Die Grafikkarte war verloren gegangen und wurde neu geöffnet.

# Why the game was started anew after its graphics had failed for good, and what draws now.
graphics-title = Die Grafik ist ausgefallen
graphics-lost = Die Grafikkarte ist verloren gegangen und ließ sich nicht wieder öffnen. Deine Welt ist gespeichert.
graphics-software = Das Spiel wurde neu gestartet, und jetzt zeichnet der Prozessor, was langsamer ist. Um es wieder mit der Grafikkarte zu versuchen, beende das Spiel und starte es noch einmal.

# Ein Absturz des Spiels zuvor.
crash-title = Das Spiel ist abgestürzt
crash = Das Spiel wurde unerwartet beendet und neu gestartet. Deine Welten und Räume sind so, wie sie zuletzt gespeichert wurden, höchstens einige Sekunden vorher. Was über den Absturz bekannt ist, steht in { $report }.

# Biome: der Name allein erscheint, wenn man eines betritt.
biome-volcanic = Vulkanland
biome-desert = Wüste
biome-forest = Wald
biome-toxic = Giftebene
biome-jungle = Dschungel
biome-tundra = Tundra
biome-wetland = Feuchtland
biome-crags = Schroffen
biome-shore = Strand
biome-cave = Höhle
