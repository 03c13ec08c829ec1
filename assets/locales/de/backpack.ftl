### The backpack over the running world.

action-backpack = Rucksack

backpack-title = Rucksack
# What a slot is called, and a thing with how many there are of it.
backpack-slot = Platz { $number }: { $item }
backpack-slot-empty = Platz { $number }: leer
backpack-item = { $item } × { $count }
backpack-throw = Wegwerfen
backpack-close = Schließen
# The page on which things are made of ground, the way to it and back, what is carried of ground, and what a thing takes of a kind out of what is there.
backpack-make = Herstellen
backpack-slots = Plätze
making-carried = Du hast dabei:
making-nothing = Du hast kein Material dabei. Grabe, um welches zu sammeln.
making-where = Kohle liegt in Flözen ab 2 m unter dem Boden, Kupfer in Adern ab 4 m, oft unter Ton, und Kristall ab 7 m, unter Kies, und in den Hallen von Höhlen.
making-earth = { $kind } { $volume } m³
making-part = { $kind } { $has } von { $needs } m³
# What the button that makes a thing is called, with what it takes.
making-recipe = { $item } herstellen: { $parts }
# What the mouse does, and what the keys do, in a few lines.
backpack-how = Linke Taste: nehmen, ablegen, ziehen · Rechte: die Hälfte nehmen, eins ablegen · Umschalt + links: in den anderen Teil · Außerhalb: wegwerfen
backpack-how-keys = Pfeile: bewegen · Enter: nehmen, ablegen · Strg + Enter: die Hälfte nehmen, eins ablegen · Umschalt + Enter: in den anderen Teil · Ziffer: mit der Leiste tauschen

# What a thing does, in a sentence.
item-gun-about = Schießt eine Kugel auf das, was das Fadenkreuz verdeckt.
item-bullet-about = Damit schießt die Pistole.
item-lamp-about = Erhellt das Land ringsum. Lässt sich hinstellen und wieder aufheben.
item-flag-about = Markiert einen Ort. Stecke sie in den Boden, klicke sie an, um sie zu benennen, nimm sie wieder mit: Karte und Kompass zeigen den Weg zu ihr.
item-door-about = Eine von zweien. Stell beide auf: Was in die eine hineingeht, kommt aus der anderen heraus. Mit der rechten Taste nimmst du sie wieder auf.
item-log-about = Ein Stück von einem Stamm. Stell es als Pfosten auf, oder mach etwas aus seinem Holz.
item-stone-about = Leg ihn hin, um damit zu bauen, oder mach etwas aus seinem Fels.
item-seed-about = Pflanz ihn in weichen Boden: Er wird ein Baum dieser Gegend und wächst von Tag zu Tag.
item-crumb-about = Leg sie auf deinen Weg: Taste halten und gehen. Karte und Kompass zeigen den Weg an ihnen entlang zurück.
item-pickaxe-wood-about = Gräbt und baut, langsam. Wo Material gesammelt wird, lässt sie Kupfer und Kristall stehen.
item-pickaxe-iron-about = Gräbt und baut dreimal so schnell wie Holz. Wo Material gesammelt wird, gräbt sie auch Kupfer.
item-pickaxe-diamond-about = Gräbt und baut fünfmal so schnell wie Holz. Wo Material gesammelt wird, gräbt sie auch Kristall.
