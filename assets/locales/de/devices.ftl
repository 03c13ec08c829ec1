### Klang und Gamepads. Zur Laufzeit gebildete Schlüssel: setting-<id>, key-<id>.

settings-group-sound = Klang
settings-group-pad = Gamepad
unit-percent = { $value } %
unit-degrees-per-second = { $value }° je Sekunde

setting-volume-master = Lautstärke
setting-volume-master-about = Von allem zusammen.
setting-volume-effects = Schritte und Werkzeug
setting-volume-effects-about = Wie laut Schritte, Landungen, Graben und Bauen sind.
setting-volume-ambience = Wind, Tag und Nacht
setting-volume-ambience-about = Wie laut der Wind ist, und tags die Vögel und nachts die Grillen.
setting-volume-music = Musik
setting-volume-music-about = Wie laut die Musik ist; sie ist leise und macht lange Pausen.
setting-volume-interface = Menüs und Leiste
setting-volume-interface-about = Wie laut es in den Menüs und auf der Leiste tickt.
setting-mute-elsewhere = Im Hintergrund stumm
setting-mute-elsewhere-about = Man hört nichts, solange ein anderes Fenster die Tastatur hat.
setting-pad-look-speed = Drehen mit dem Stick
setting-pad-look-speed-about = Wie schnell sich die Sicht dreht, wenn der rechte Stick ganz ausgelenkt ist.
setting-pad-invert-look = Oben und unten am Stick tauschen
setting-pad-invert-look-about = Den rechten Stick wegdrücken sieht nach unten, wie im Flugzeug.
setting-pad-dead-zone = Ruhe der Sticks
setting-pad-dead-zone-about = Wie weit ein Stick von der Mitte stehen darf und noch als losgelassen gilt. Mehr hilft, wo sich die Sicht von selbst dreht.

sound-none = Es gibt kein Klanggerät; das Spiel geht ohne weiter. Eines, das angesteckt wird, wird genommen.
sound-lost = Das Klanggerät ist fort; das Spiel geht ohne weiter und wartet auf eines.
sound-left-out = Dieses Spiel wurde ohne Klang gebaut.

pad-connected = Gamepad verbunden: { $name }
pad-disconnected = Gamepad fort: { $name }

key-pad-south = Pad A, unten
key-pad-east = Pad B, rechts
key-pad-west = Pad X, links
key-pad-north = Pad Y, oben
key-pad-left-bumper = Pad linke Schultertaste
key-pad-right-bumper = Pad rechte Schultertaste
key-pad-left-trigger = Pad linker Abzug
key-pad-right-trigger = Pad rechter Abzug
key-pad-select = Pad Select
key-pad-start = Pad Start
key-pad-left-stick = Pad linker Stick gedrückt
key-pad-right-stick = Pad rechter Stick gedrückt
key-pad-up = Pad Kreuz oben
key-pad-down = Pad Kreuz unten
key-pad-left = Pad Kreuz links
key-pad-right = Pad Kreuz rechts
