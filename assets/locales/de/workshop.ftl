### Die Werkstatt, in der Räume gebaut werden.

# Räume zum Bauen.
workshop-rooms-none = Du hast noch keine eigenen Räume. Lege einen neuen an, oder kopiere einen des Spiels auf seiner Seite (die drei Punkte). Zum ersten gehört eine Lektion.
workshop-rooms-shipped = Räume des Spiels
workshop-rooms-load = Bauen
workshop-rooms-load-named = In „{ $name }“ bauen
workshop-not-own = Dieser Raum gehört zum Spiel. Kopiere ihn, und baue in der Kopie.
workshop-not-kept = Der Raum konnte nicht gespeichert werden: { $reason }
workshop-not-saved-yet = Deine Änderungen sind aufbewahrt, aber die Datei des Raums bleibt, wie sie war, bis dies behoben ist: { $reason }
workshop-kept = Der Raum wird gespeichert. Er speichert sich auch selbst: jeden Schritt innerhalb von zwei Sekunden.

# Die Felder des Fensters.
workshop-pane-view = Ansicht
workshop-pane-list = Dinge
workshop-pane-inspector = Eigenschaften
workshop-pane-parts = Bauteile
workshop-pane-messages = Meldungen
workshop-pane-history = Verlauf
workshop-search = Suchen
workshop-none-found = Nichts heißt so.
workshop-rename = Neuer Name
workshop-hide = „{ $name }“ verbergen
workshop-fold = „{ $name }“ einklappen
workshop-lock = „{ $name }“ sperren
workshop-reset = { $name } zurücksetzen
workshop-parts-hint = Ein Klick setzt ein Bauteil auf das, was du ansiehst.
workshop-all-well = Mit diesem Raum ist alles in Ordnung.
workshop-note-ahead = Die letzten Änderungen dieses Raums standen noch nicht in seiner Datei, als das Spiel endete. Sie sind wieder da; es ist nichts zu tun.
workshop-note-changed = Etwas anderes hat die Datei dieses Raums geändert, seit er hier zuletzt gespeichert wurde. Das ist der letzte Schritt des Verlaufs; nimm ihn zurück, um den Raum wie vorher zu haben.
workshop-note-aside = Das Journal dieses Raums war beschädigt und liegt jetzt als { $file } beiseite. Ältere Schritte können fehlen; „Ältere Fassungen“ im Verlauf zeigt, was sonst noch da ist.
workshop-in-use = In diesem Raum baut gerade ein anderes Fenster des Spiels. Hier kannst du ihn durchgehen; schließe ihn erst dort, um hier zu bauen.
workshop-no-journal = In den Ordner dieses Raums kann nicht geschrieben werden ({ $reason }). Du kannst den Raum durchgehen; um zu bauen, mache den Ordner beschreibbar und betritt ihn neu.
workshop-drop-elsewhere = Dateien kannst du in einen Raum ziehen, während du in ihm baust: Werkstatt im Hauptmenü, oder F5 in einem eigenen Raum.
workshop-drop-choose = Wähle zuerst, worauf das Bild liegen soll, und hole es dann noch einmal.
workshop-older = Ältere Fassungen
workshop-older-about = Ein Klick setzt die Fassung an die Stelle des Raums. Das ist ein Schritt, der sich zurücknehmen lässt.
workshop-older-none = Noch gibt es keine älteren Fassungen. Eine halbe Minute nach einer Änderung entsteht eine.
workshop-beginning = Der Anfang
workshop-room-itself = Der Raum selbst
workshop-one = { $name } ({ $kind })
workshop-several = { $count ->
    [one] { $count } Ding
   *[other] { $count } Dinge
}
workshop-status-nothing = Klicke etwas an, oder fliege: rechte Taste halten, dazu W A S D, E, Q.
workshop-status-chosen = Ziehe es oder einen Griff · Pfeiltasten: ein Schritt · F: ansehen · Alt: ohne Raster
workshop-status-turn = Zieh einen Ring: Schritte von 15° · F: ansehen · Alt: ohne Raster
workshop-status-scale = Zieh einen Griff: die andere Seite bleibt · F: ansehen · Alt: ohne Raster
workshop-status-scale-whole = Zieh einen Griff: alles wächst · F: ansehen
workshop-status-flies = W A S D, E und Q fliegen, Pfeiltasten drehen. V oder Esc beendet es.
workshop-status-late = Wird neu gezeichnet …
workshop-outside-inside = außen { $outside } m, innen { $inside } m

# Was getan wird.
workshop-do-play = Spielen
workshop-do-leave = Den Raum verlassen
workshop-do-undo = Rückgängig
workshop-do-redo = Wiederholen
workshop-do-move = Schieben
workshop-do-turn = Drehen
workshop-do-scale = Größe
workshop-do-own-axes = Eigene Achsen
workshop-do-snaps = Raster
workshop-do-on-surfaces = Auf Flächen
workshop-do-copy = Kopieren
workshop-do-cut = Ausschneiden
workshop-do-paste = Einfügen
workshop-do-duplicate = Verdoppeln
workshop-do-array = In Reihe wiederholen
workshop-do-group = Gruppieren
workshop-do-ungroup = Gruppe auflösen
workshop-do-delete = Löschen
workshop-do-choose-all = Alles wählen
workshop-do-focus = Auswahl ansehen
workshop-do-top = Von oben
workshop-do-front = Von vorn
workshop-do-side = Von der Seite
workshop-do-start = Vom Start aus
workshop-do-flies = Mit Tasten fliegen
workshop-do-raster = Erst ein schnelles Bild
workshop-grid = { $metres } m
workshop-menu-edit = Bearbeiten
workshop-menu-room = Raum
workshop-menu-view = Ansicht
workshop-key-ctrl = Strg
workshop-key-shift = Umschalt

# Einheiten.
workshop-unit-metres = { $value } m
workshop-unit-degrees = { $value }°
workshop-unit-times = × { $value }
workshop-unit-plain = { $value }

# Arten von Dingen.
workshop-kind-box = Quader
workshop-kind-pyramid = Pyramide
workshop-kind-ramp = Rampe
workshop-kind-cylinder = Zylinder
workshop-kind-ball = Kugel
workshop-kind-stairs = Treppe
workshop-kind-arch = Bogen
workshop-kind-model = Modell
workshop-kind-light = Lampe
workshop-kind-aberration = Innenraum
workshop-kind-portal = Portal
workshop-kind-sign = Schild
workshop-kind-group = Gruppe

# Bauteile.
workshop-part-box = Quader
workshop-about-box = Ein Block von einem Meter.
workshop-part-wall = Wand
workshop-about-wall = 4 m breit, 2,5 m hoch.
workshop-part-floor = Boden
workshop-about-floor = Eine Platte von 4 mal 4 m.
workshop-part-pyramid = Pyramide
workshop-about-pyramid = Ihre Spitze ist oben.
workshop-part-ramp = Rampe
workshop-about-ramp = Sie steigt nach vorn.
workshop-part-stairs = Treppe
workshop-about-stairs = Acht Stufen, 2 m hoch.
workshop-part-arch = Bogen
workshop-about-arch = Ein Block mit einem Tor darin.
workshop-part-cylinder = Zylinder
workshop-about-cylinder = Aufrecht, 2 m hoch.
workshop-part-ball = Kugel
workshop-about-ball = Eine Kugel von einem Meter.
workshop-part-light = Lampe
workshop-about-light = Licht aus einem Punkt; höchstens acht je Raum.
workshop-part-sign = Schild
workshop-about-sign = Eine Tafel zum Lesen.
workshop-part-tunnel = Tunnel
workshop-about-tunnel = Außen 4 m, innen 20 m, mit eigenen Wänden. Nichts wird darin gebogen.
workshop-part-hall = Größerer Raum
workshop-about-hall = Ein offener Kasten, innen doppelt so groß. Wer eintritt, ist halb so groß. Stell Wände darum, oder nimm das Haus.
workshop-part-portals = Portalpaar
workshop-about-portals = Wer in das eine geht, kommt aus dem anderen.

# Eigenschaften.
workshop-field-name = Name
workshop-field-at = Ort
workshop-field-at-group = Ort in der Gruppe
workshop-field-turn = Drehung (um y, z, x)
workshop-field-size = Größe
workshop-field-radius = Radius
workshop-field-height = Höhe
workshop-field-steps = Stufen
workshop-field-opening = Tor
workshop-field-scale = Maßstab
workshop-field-text = Text
workshop-field-colour = Farbe
workshop-field-power = Helligkeit
workshop-field-checker = Kariert
workshop-field-checker-colour = Zweite Farbe
workshop-field-checker-size = Seite eines Karos
workshop-field-texture-file = Bild
workshop-texture-none = Ein Bild kann darauf liegen: Strg+O.
workshop-field-texture-size = Seite des Bildes
workshop-field-finish = Oberfläche
workshop-field-glow = Leuchten
workshop-field-box = Größe außen
workshop-field-lengths = Was es dehnt
workshop-field-axis = Achse
workshop-field-felt = Länge innen
workshop-field-times = Dehnung
workshop-field-times-x = Dehnung entlang x
workshop-field-times-y = Dehnung entlang y
workshop-field-times-z = Dehnung entlang z
workshop-field-thesis = d der Abschlussarbeit
workshop-field-sides = Seiten
workshop-field-ways = Wirkt auf
workshop-field-outline = Kanten sichtbar
workshop-field-to = Führt zu
workshop-field-sentence = Was hier seltsam ist
workshop-field-spawn-at = Start
workshop-field-spawn-look = Blick am Start (Gier, Nick)
workshop-field-gravity = Schwerkraft
workshop-field-sky = Himmel
workshop-field-light = Umgebungslicht
workshop-field-has-sun = Sonne
workshop-field-sun = Wo sie steht
workshop-field-sun-colour = Farbe der Sonne
workshop-field-sun-power = Helligkeit der Sonne
workshop-field-has-fog = Nebel
workshop-field-fog = Nichts zu sehen ab
workshop-field-fog-colour = Farbe des Nebels
workshop-choice-finish-matt = Matt
workshop-choice-finish-mirror = Spiegel
workshop-choice-finish-glass = Glas
workshop-choice-lengths-felt = Eine Achse
workshop-choice-lengths-stretch = Alle Achsen
workshop-choice-axis-x = x (rot)
workshop-choice-axis-y = y (grün)
workshop-choice-axis-z = z (blau)
workshop-choice-sides-walls = Wände
workshop-choice-sides-soft = Offen
workshop-choice-sides-snell = Brechend
workshop-choice-sides-legacy = Regel der Abschlussarbeit
workshop-choice-sides-1 = Eine Seite
workshop-choice-sides-2 = Beide Seiten
workshop-choice-ways-both = Alle, die eintreten
workshop-choice-ways-forward = Nur wer entlang der Achse geht

# Was der Raum tut.
workshop-told-felt = Außen ist es { $outside } m lang und innen { $inside } m: { $seconds } s zu Fuß statt { $before }.
workshop-told-smaller = Wer eintritt, ist { $times }-mal kleiner, also ist alles darin so viel größer. Der Blick wird davon nicht gebogen.
workshop-told-larger = Wer eintritt, ist { $times }-mal größer, also ist alles darin so viel kleiner. Der Blick wird davon nicht gebogen.
workshop-told-walls = Es hat eigene Wände; nichts wird gebogen, und die Türen sind innen so groß wie außen.
workshop-told-soft = Richtungen bleiben durch jede Seite gleich: man geht zu dem, was man sieht.
workshop-told-snell = Licht wird gebrochen wie in Glas und ab einem Winkel gespiegelt.
workshop-told-legacy = Die Regel der Abschlussarbeit hat Fehler: was man sieht, hängt vom Blick ab, und man geht nicht dorthin.
workshop-told-no-door = Wände lassen keine Tür, wo mehr als eine Achse gedehnt ist. Dehne nur eine, oder mache die Seiten offen.
workshop-told-astigmatic = Gerade Linien sehen hindurch gebogen aus, weil die Seiten ungleich gedehnt sind.
workshop-told-grazing = An seinen Seiten entlang sieht alles gestaucht aus.
workshop-told-itself = Es führt zu sich selbst: man sieht sich hineinschauen.
workshop-told-alike = Es ist so groß wie „{ $name }“: wer durchgeht, behält seine Größe.
workshop-told-grows = Wer zu „{ $name }“ geht, wird { $times }-mal so groß.
workshop-told-shrinks = Wer zu „{ $name }“ geht, wird { $times }-mal kleiner.

# Schritte im Verlauf.
workshop-step-add = { $count ->
    [one] „{ $name }“ hinzufügen
   *[other] { $count } Dinge hinzufügen
}
workshop-step-remove = { $count ->
    [one] „{ $name }“ löschen
   *[other] { $count } Dinge löschen
}
workshop-step-move = { $count ->
    [one] „{ $name }“ schieben
   *[other] { $count } Dinge schieben
}
workshop-step-turn = { $count ->
    [one] „{ $name }“ drehen
   *[other] { $count } Dinge drehen
}
workshop-step-pose = { $count ->
    [one] „{ $name }“ stellen
   *[other] { $count } Dinge stellen
}
workshop-step-resize = { $count ->
    [one] Größe von „{ $name }“
   *[other] Größe von { $count } Dingen
}
workshop-step-stretch = { $count ->
    [one] „{ $name }“ dehnen
   *[other] { $count } Dinge dehnen
}
workshop-step-sides = { $count ->
    [one] Seiten von „{ $name }“
   *[other] Seiten von { $count } Dingen
}
workshop-step-surface = { $count ->
    [one] Oberfläche von „{ $name }“
   *[other] Oberfläche von { $count } Dingen
}
workshop-step-link = { $count ->
    [one] „{ $name }“ verbinden
   *[other] { $count } Portale verbinden
}
workshop-step-text = { $count ->
    [one] Text von „{ $name }“
   *[other] Text von { $count } Schildern
}
workshop-step-light = { $count ->
    [one] Licht von „{ $name }“
   *[other] Licht von { $count } Lampen
}
workshop-step-change = { $count ->
    [one] „{ $name }“ ändern
   *[other] { $count } Dinge ändern
}
workshop-step-rename = „{ $name }“ heißt jetzt „{ $new }“
workshop-step-group = Gruppe „{ $name }“
workshop-step-carry = { $count ->
    [one] „{ $name }“ aus der Gruppe nehmen
   *[other] { $count } Dinge aus Gruppen nehmen
}
workshop-step-ungroup = { $count ->
    [one] Gruppe „{ $name }“ auflösen
   *[other] { $count } Gruppen auflösen
}
workshop-step-duplicate = { $count ->
    [one] „{ $name }“ verdoppeln
   *[other] { $count } Dinge verdoppeln
}
workshop-step-array = { $count ->
    [one] „{ $name }“ wiederholen
   *[other] { $count } Dinge wiederholen
}
workshop-step-paste = { $count ->
    [one] „{ $name }“ einfügen
   *[other] { $count } Dinge einfügen
}
workshop-step-room = Der Raum selbst
workshop-step-spawn = Der Start
workshop-step-several = Mehrere Änderungen
workshop-step-outside = Außerhalb des Spiels geändert
workshop-step-version = Fassung { $when }

# Was nicht stimmen mag.
workshop-finding-not-parallel = „{ $name }“ liegt teilweise in „{ $other }“ und ist anders gedreht; es bleibt zu, bis die Achsen parallel sind oder eines ganz im anderen liegt.
workshop-finding-too-deep = „{ $name }“ liegt in zu vielen ineinander liegenden gedehnten Räumen, darunter „{ $other }“; höchstens acht sind erlaubt.
workshop-finding-walls-across = Eine Wand von „{ $name }“ steht quer in „{ $other }“, dort kommt niemand durch; rücke eins davon weg.
workshop-finding-same-place = „{ $name }“ ist am selben Ort wie „{ $other }“; rücke es weg oder entferne es.
workshop-finding-tangled = „{ $name }“ liegt in so vielen anderen, dass die Tiefe unklar ist; rücke einige auseinander.
workshop-finding-no-door = „{ $name }“ hat an allen sechs Seiten Wände, und niemand könnte eintreten.
workshop-finding-out-of-range = „{ $name }“ hat eine Zahl außerhalb des Erlaubten.
workshop-finding-no-partner = Das Portal „{ $name }“ führt nirgendwohin: es gibt kein Portal mit dem Namen seines Ziels.
workshop-finding-one-way = Das Portal „{ $name }“ führt zu „{ $other }“, das nicht zurückführt.
workshop-finding-other-sides = „{ $name }“ und „{ $other }“ haben nicht gleich viele Seiten.
workshop-finding-not-similar = „{ $name }“ fühlt sich seinem Partner „{ $other }“ nicht ähnlich an: gib ihnen Größen im gleichen Verhältnis.
workshop-finding-other-size = „{ $name }“ weicht in der Größe um mehr als das 32-Fache von „{ $other }“ ab.
workshop-finding-portal-shape = Die Ecken von „{ $name }“ bilden keine konvexe Form.
workshop-finding-over-side = Das Portal „{ $name }“ liegt über einer Seite von „{ $other }“; stelle es ganz hinein oder hinaus.
workshop-finding-in-odd-box = Das Portal „{ $name }“ steht in „{ $other }“, wo keine Portale stehen können.
workshop-finding-portals-touch = Die Portale „{ $name }“ und „{ $other }“ berühren sich; rücke sie mindestens einen Millimeter auseinander.
workshop-finding-spawn-in-solid = Der Start liegt in „{ $name }“.
workshop-finding-spawn-in-air = { $metres ->
    [0] Man beginnt über nichts und fällt aus dem Raum.
    [one] Man beginnt in der Luft und fällt { $metres } m.
   *[other] Man beginnt in der Luft und fällt { $metres } m.
}
workshop-finding-open-sides = Die Seiten von „{ $name }“ sind offen: dort wird Licht gebogen. Verdecke sie oder gib ihm Wände.
workshop-finding-fall-out = Man kann aus dem Raum fallen, nach { $metres } m zu Fuß.
workshop-finding-unreached = „{ $name }“ ist vom Anfang aus zu Fuß nicht zu erreichen.

# Help, and parts of several things.
workshop-reset-short = zurücksetzen
workshop-menu-help = Hilfe
workshop-do-lesson = Die Lektion machen
workshop-do-examples = Was möglich ist
workshop-do-parallel = Ohne Perspektive
workshop-do-walls = Wände von Tunneln ausblenden
workshop-field-times-all = Dehnung aller Achsen
workshop-field-group = In der Gruppe
workshop-choice-group-none = Keine
workshop-part-house = Haus, innen größer
workshop-about-house = Ein Haus von 4 m mit einer Tür. Innen ist es doppelt so groß, und wer eintritt, halb so groß.

# The lesson.
workshop-lesson-title = Lektion, Schritt { $number } von { $of }
workshop-lesson-put = Klicke unter den Bauteilen auf „Haus, innen größer“: dann steht es vor dir.
workshop-lesson-move = Ziehe das Haus mit der linken Taste ein wenig zur Seite.
workshop-lesson-choose = Klicke in der Liste der Dinge auf „{ $name }“: das ist der Raum im Haus.
workshop-lesson-stretch = Ziehe den Regler „Dehnung aller Achsen“ nach rechts: das Haus wird innen größer und bleibt außen, wie es ist.
workshop-lesson-enter = Drücke Spielen (F5) und geh durch die Tür hinein.
workshop-lesson-walk = Geh durch die Tür in das Haus. F5 führt zurück in die Werkstatt.
workshop-lesson-walk-tunnel = Geh durch den Tunnel und zähl deine Schritte. F5 führt zurück in die Werkstatt.
workshop-lesson-done = Du hast ein Haus gebaut, das innen größer ist. Zurück in der Werkstatt (F5) hat die Hilfe eine zweite Lektion, über Tunnel und Portale, und zeigt, was noch möglich ist.
workshop-lesson-skip = Schritt auslassen
workshop-lesson-end = Lektion beenden

# What is possible.
workshop-examples-title = Was möglich ist
workshop-examples-about = Jedes davon kann in deinen Raum kopiert und dort geändert werden.
workshop-examples-copy = In den Raum kopieren
workshop-examples-copy-named = „{ $name }“ in den Raum kopieren
workshop-examples-close = Schließen
workshop-example-tunnel-longer = Tunnel, innen länger
workshop-example-tunnel-longer-about = 4 m daneben, 20 m hindurch.
workshop-example-tunnel-shorter = Tunnel, innen kürzer
workshop-example-tunnel-shorter-about = 16 m daneben, 2 m hindurch.
workshop-example-house = Haus, innen größer
workshop-example-house-about = Außen vier Meter, innen acht.
workshop-example-portals = Portalpaar
workshop-example-portals-about = Wer in das eine geht, kommt aus dem anderen.
workshop-example-portals-of-size = Verschieden große Portale
workshop-example-portals-of-size-about = Wer aus dem großen kommt, ist dreimal so groß.
workshop-example-falling-loop = Ein Fall ohne Ende
workshop-example-falling-loop-about = Was unten hineinfällt, kommt oben heraus.

# Partners of portals.
workshop-link-to = Zieh ihn auf ein anderes Portal.
workshop-link-partner = Führt zu „{ $name }“: auf ein anderes ziehen
workshop-told-no-partner = Es führt nirgendwohin und ist geschlossen: wähle das Portal, zu dem es führt.
workshop-told-one-way = Es ist geschlossen: „{ $name }“ führt nicht zurück.
workshop-told-other-sides = Es ist geschlossen: „{ $name }“ hat eine andere Zahl von Seiten.
workshop-told-not-similar = Es ist geschlossen: „{ $name }“ hat eine andere Form. Gib beiden dasselbe Verhältnis von Breite zu Höhe.
workshop-told-ill-placed = Es ist geschlossen: es oder „{ $name }“ steht, wo keines stehen darf. Die Meldungen sagen, warum.

# Files from the disk.
workshop-do-from-file = Modell oder Bild aus einer Datei
workshop-do-keep = Jetzt speichern
workshop-chooser-title = Ein Modell oder ein Bild
workshop-chooser-about = Ein Modell (glb, gltf, fbx, obj) steht dann vor dir; ein Bild (png, jpg) liegt auf dem, was gewählt ist.
workshop-chooser-path = Pfad
workshop-chooser-open = Öffnen
workshop-chooser-up = Ordner darüber
workshop-chooser-home = Mein Ordner
workshop-chooser-close = Abbrechen
workshop-chooser-reading = Der Ordner wird gelesen.
workshop-chooser-empty = Hier ist kein Ordner, kein Modell und kein Bild.
workshop-chooser-folder = Ordner
workshop-chooser-unread = { $path } kann nicht gelesen werden ({ $reason }). Gib einen anderen Pfad ein, oder geh vom Ordner unten weiter.
workshop-chooser-unfit = { $path } ist kein Modell (glb, gltf, fbx, obj) und kein Bild (png, jpg). Speichere es als eines davon, oder wähle eine andere Datei.
workshop-chooser-many = Gezeigt werden die ersten { $shown } von { $count }; gib den Pfad eines anderen ein.

# What fields do, where the pointer rests.
workshop-hover-sides = Was an den Seiten ist, durch die niemand gehen soll: Wände, nichts, oder etwas wie Glas.
workshop-hover-ways = Wer vom anderen Ende kommt, findet den Raum auf Wunsch so lang, wie er aussieht.
workshop-hover-outline = Die Kanten des Kastens sind auch im Spiel zu sehen, nicht nur hier.
workshop-hover-lengths = Eine Achse macht einen Tunnel länger oder kürzer; alle Achsen machen einen Raum innen größer oder kleiner.
workshop-hover-thesis = So zählt eine Abschlussarbeit, das erste Programm solcher Räume, die Dehnung, andersherum: Ein Meter innen nimmt außen 1 + d Meter ein. 0 ändert nichts, 2 ist innen ein Drittel so lang, −0,8 fünfmal so lang.

# The second lesson, and a portal alone.
workshop-do-lesson-doors = Lektion: Tunnel und Portale
workshop-part-portal = Portal
workshop-about-portal = Es führt zu sich selbst, bis eine Linie von ihm zu einem anderen gezogen wird.
workshop-lesson-tunnel = Klicke unter den Bauteilen auf „Tunnel“: dann steht er vor dir.
workshop-lesson-longer = Ziehe, während „{ $name }“ gewählt ist, den Regler „Dehnung“ nach rechts: innen wird er länger, außen bleibt er, wie er ist.
workshop-lesson-portal = Klicke unter den Bauteilen auf „Portal“: es ist das erste von zweien.
workshop-lesson-portal-again = Klicke noch einmal auf „Portal“: das zweite steht neben dem ersten.
workshop-lesson-link = Ziehe vom Knopf über „{ $name }“ in die Mitte von „{ $other }“: dann führen sie zueinander.
workshop-lesson-through = Drücke Spielen (F5) und geh durch den Tunnel.
workshop-lesson-pass = Drücke Spielen (F5) und geh in ein Portal: du kommst aus dem anderen heraus.
workshop-lesson-walk-doors = Das war der Tunnel. Geh nun in ein Portal. F5 führt zurück in die Werkstatt.
workshop-lesson-done-doors = Du hast einen Tunnel gebaut, der innen länger ist, und zwei Portale, die zueinander führen. Die Hilfe in der Werkstatt (F5) zeigt, was noch möglich ist.
workshop-link-itself = Führt zu sich selbst: zu einem anderen Portal ziehen
workshop-link-nowhere = Führt nirgendwohin: zu einem Portal ziehen
workshop-hover-own-axes = Griffe richten sich nach den Achsen des Dings, nicht nach denen des Raums.
workshop-hover-snaps = Verschoben wird in Schritten des Gitters, gedreht um 15°. Mit Alt ohne Schritte.
workshop-hover-on-surfaces = Was gezogen wird, liegt auf der Fläche unter dem Zeiger: Böden, Wände, Dächer.

# What parts and their things are called in a room.
workshop-name-bottom = unten
workshop-name-top = oben
workshop-name-falling-loop = Fallschleife
workshop-name-falling-loop-lintel = Sturz der Fallschleife
workshop-name-falling-loop-pillar = Pfeiler der Fallschleife
workshop-name-falling-loop-rim = Rand der Fallschleife
workshop-name-house = Haus
workshop-name-house-back = Haus Rückwand
workshop-name-house-ceiling = Haus Decke
workshop-name-house-floor = Haus Boden
workshop-name-house-front = Haus Vorderwand
workshop-name-house-inside = Haus Innenraum
workshop-name-house-lamp = Haus Lampe
workshop-name-house-left = Haus linke Wand
workshop-name-house-light = Haus Licht
workshop-name-house-lining-back = Haus Verkleidung hinten
workshop-name-house-lining-front = Haus Verkleidung vorn
workshop-name-house-lining-left = Haus Verkleidung links
workshop-name-house-lining-right = Haus Verkleidung rechts
workshop-name-house-right = Haus rechte Wand
workshop-name-house-roof = Haus Dach
workshop-name-large-portal = großes Portal
workshop-name-large-portal-frame = großer Portalrahmen
workshop-name-left-post = linker Pfosten
workshop-name-lintel = Sturz
workshop-name-long-tunnel = langer Tunnel
workshop-name-long-tunnel-inside = langer Tunnel innen
workshop-name-long-tunnel-slab = langer Tunnel Platte
workshop-name-portal = Portal
workshop-name-portal-frame = Portalrahmen
workshop-name-right-post = rechter Pfosten
workshop-name-short-tunnel = kurzer Tunnel
workshop-name-short-tunnel-inside = kurzer Tunnel innen
workshop-name-short-tunnel-slab = kurzer Tunnel Platte
workshop-name-small-portal = kleines Portal
workshop-name-small-portal-frame = kleiner Portalrahmen
workshop-name-tunnel = Tunnel
workshop-name-hall = Raum
workshop-name-box = Quader
workshop-name-wall = Wand
workshop-name-floor = Boden
workshop-name-stairs = Treppe
workshop-name-ramp = Rampe
workshop-name-arch = Bogen
workshop-name-pyramid = Pyramide
workshop-name-cylinder = Zylinder
workshop-name-ball = Kugel
workshop-name-light = Licht
workshop-name-sign = Schild
workshop-name-group = Gruppe
workshop-name-model = Modell
workshop-told-carried = Alles, was sie trägt, ist { $x } m breit, { $y } m hoch und { $z } m tief.

# The form of how something is repeated in a row.
workshop-array-count = Wie oft
workshop-array-axis = Entlang
workshop-array-gap = Frei dazwischen
workshop-array-turn = Gedreht, je
workshop-array-make = Anlegen
workshop-array-close = Schließen
workshop-misread = „{ $text }“ ist keine Zahl: es bleibt, wie es war.
