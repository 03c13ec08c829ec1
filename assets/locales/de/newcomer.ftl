### Hints for newcomers, shown one after another in the first world.

hints-look = Umsehen: { $key }
hints-walk = Gehen: { $key }
hints-jump = Springen: { $key }
hints-corner = An jeder Ecke treffen sich fünf Quadrate, nicht vier, und dort steht ein Stein, von dem fünf Wege ausgehen. Geh um ihn herum und zähl sie. Durchquert: { $gone } · große Karte: { $key }
hints-corner-back = Fünf Quadrate, und du bist zurück. Auf ebenem Grund wären es vier gewesen.
hints-overhead = Schau nach oben: Das Land über deinem Kopf ist die andere Seite dieser Welt.
hints-talk = Mit jemandem vor dir reden: { $key }
hints-car = In ein Auto einsteigen, aus der Nähe: { $key }
hints-map = Das andere Bild dieses Raums: { $key }
hints-camera = Dich von hinten sehen, und zurück: { $key }
hints-light = Es ist dunkel. Taschenlampe: { $key }
hints-photo = Bilder machen: { $key }
hints-home = Geh immer geradeaus, gleich in welche Richtung, bis du zu Hause bist.
hints-dig = Graben, gedrückt halten: { $key }
hints-build = Bauen, gedrückt halten: { $key }
hints-make = Du baust mit dem, was du abbaust. Mach Werkzeug daraus: { $key }, dann „Herstellen“
hints-curve = Den Raum anders abbilden: { $up } und { $down }
hints-backpack = Den Rucksack öffnen: { $key }
hints-menu = Pause, Einstellungen, alle Tasten: { $key }
hints-footer = { $step } von { $count } · überspringen: { $key }
hints-footer-plain = { $step } von { $count }
hints-stick-left = linker Stick
hints-stick-right = rechter Stick

menu-skip-hints = Tipps überspringen
action-skip-hint = Tipp überspringen
setting-hints = Tipps für den Anfang
setting-hints-about = Sagen in der Welt der Reihe nach, was man tun kann. Nach dem letzten schalten sie sich ab; eingeschaltet beginnen sie von vorn.
