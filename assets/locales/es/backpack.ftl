### The backpack over the running world.

action-backpack = Mochila

backpack-title = Mochila
# What a slot is called, and a thing with how many there are of it.
backpack-slot = Hueco { $number }: { $item }
backpack-slot-empty = Hueco { $number }: vacío
backpack-item = { $item } × { $count }
backpack-throw = Tirar
backpack-close = Cerrar
# The page on which things are made of ground, the way to it and back, what is carried of ground, and what a thing takes of a kind out of what is there.
backpack-make = Fabricar
backpack-slots = Huecos
making-carried = Llevas:
making-nothing = No llevas material. Cava para reunirlo.
making-where = El carbón está en capas desde 2 m bajo el suelo; el cobre, en vetas desde 4 m, a menudo bajo arcilla; y el cristal, desde 7 m, bajo grava, y en las salas de las cuevas.
making-earth = { $kind } { $volume } m³
making-part = { $kind } { $has } de { $needs } m³
# What the button that makes a thing is called, with what it takes.
making-recipe = Fabricar { $item }: { $parts }
# What the mouse does, and what the keys do, in a few lines.
backpack-how = Botón izquierdo: tomar, dejar, arrastrar · Derecho: tomar la mitad, dejar uno · Mayús + izquierdo: a la otra parte · Fuera: tirar
backpack-how-keys = Flechas: mover · Intro: tomar, dejar · Ctrl + Intro: tomar la mitad, dejar uno · Mayús + Intro: a la otra parte · Número: cambiar con la barra

# What a thing does, in a sentence.
item-gun-about = Dispara una bala a lo que cubre la mira.
item-bullet-about = Lo que dispara la pistola.
item-lamp-about = Ilumina los alrededores. Se puede colocar y volver a recoger.
item-flag-about = Marca un lugar. Clávala, haz clic en ella para darle un nombre y recógela cuando quieras: el mapa y la brújula muestran el camino.
item-door-about = Una de un par. Coloca las dos: lo que entra por una sale por la otra. Recógela con el botón derecho.
item-log-about = Un trozo de tronco. Ponlo de pie como poste o haz cosas con su madera.
item-stone-about = Colócala para construir o haz cosas con su roca.
item-seed-about = Plántala en terreno blando: será un árbol de esa tierra y crecerá día a día.
item-crumb-about = Déjalas por tu camino: mantén el botón y camina. El mapa y la brújula muestran el camino de vuelta.
item-pickaxe-wood-about = Cava y construye, despacio. Donde se reúne material, no puede con el cobre ni el cristal.
item-pickaxe-iron-about = Cava y construye tres veces más rápido que la madera. Donde se reúne material, cava también cobre.
item-pickaxe-diamond-about = Cava y construye cinco veces más rápido que la madera. Donde se reúne material, cava también cristal.
