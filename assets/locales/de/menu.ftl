### Das Hauptmenü, das Formular für eine neue Welt und die Dialoge.

# Die Spalte der Knöpfe.
menu-resume = Weiterspielen
menu-save = Speichern
menu-save-and-quit = Speichern und zum Menü
menu-begin-anew = Von vorn
menu-build-here = Hier bauen
menu-leave-room = Den Raum verlassen
menu-new-game = Neues Spiel
menu-load = Laden
menu-delete = Löschen
menu-rooms = Räume
menu-workshop = Werkstatt
menu-controls = Steuerung
menu-quit = Beenden
version = Version { $version }
adapter-software = Keine Grafikkarte gefunden: der Prozessor zeichnet ({ $adapter }), in { $percent } % der Fensterauflösung. Ein kleines Fenster oder kleine Sichtweite hilft.
running-world = { $name } · Startwert { $seed }

back = Zurück
ok = OK
percent = { $percent } %

# Das Formular für eine neue Welt.
name = Name
name-hint = Wie soll sie heißen?
name-offered = Welt { $number }
name-free = Dieser Name ist frei.
name-not-shown = Einige der Zeichen lassen sich hier nicht zeigen: Der Name des Ordners wird daneben stehen.
space = Raum
geometry-hyperbolic = Hyperbolische Linse
geometry-hyperbolic-about = Flaches, endloses Land, gesehen im gekrümmten Raum: Es fällt ringsum ab, so stark du am Rad drehst.
geometry-hyperbolic-world = Hyperbolische Welt
geometry-hyperbolic-world-about = Mehr Platz als auf flachem Land: An jeder Ecke treffen sich fünf Quadrate, und der Rückweg ist nicht der, den du erwartest.
geometry-euclidean = Euklidisch
geometry-euclidean-about = Flacher Raum, endlos und vertraut.
geometry-spherical = Sphärisch
geometry-spherical-about = Eine geschlossene Welt: Das Land steigt an und trifft sich über dem Kopf, und einmal um sie herum geht es nach Hause.
mode = Modus
mode-creative = Kreativ
mode-creative-about = Alle Werkzeuge von Anfang an; Bauen kostet nichts.
mode-gathering = Sammeln
mode-gathering-about = Du baust mit dem, was du ausgräbst, und machst daraus Werkzeuge.
seed = Startwert (freiwillig)
seed-hint = Eine Zahl oder Wörter
seed-random = Bleibt er leer, wird er ausgelost.
seed-is = Der Startwert ist { $seed }.
seed-too-large = Zu groß: Der größte Startwert ist 18446744073709551615.
seed-not-whole = Eine Zahl muss ganz und nicht negativ sein: nur Ziffern.
seed-too-long = Zu lang: höchstens 64 Zeichen.
seed-unprintable = Bitte nur sichtbare Zeichen.
radius-metres = { $metres } m
radius = Größe: der Radius der Welt
radius-moonlet = Möndchen
radius-moon = Mond
radius-planet = Planet
radius-named = { $name }, { $metres } m
radius-round = Einmal herum: { $metres } m, { $minutes } Minuten zu Fuß.
squares = Größe: wie breit ein Quadrat ist, fünf um jede Ecke
squares-wide = { $metres } m
squares-land = Innerhalb von { $metres } m gibt es { $times }-mal so viel Land wie auf flachem Boden.
create = Erschaffen
needs-name = Braucht einen gültigen Namen
needs-seed = Braucht einen gültigen Startwert

# Eine Welt, die vor dem Verlassen nicht gespeichert werden konnte.
unsaved-title = Die Welt ist nicht gespeichert
unsaved-again = Nochmals versuchen
unsaved-stay = In der Welt bleiben
unsaved-leave = Ohne Speichern gehen

# Worauf der Spieler wartet.
busy-opening = Öffnen
busy-opening-about = Die Welt wird von der Platte gelesen.
busy-opening-room = Der Raum wird von der Platte gelesen und sein Bild vorbereitet.
busy-land = Das Land entsteht
busy-saving = Speichern
busy-saving-about = Deine Welt wird auf die Platte geschrieben.
busy-leaving = Verlassen
