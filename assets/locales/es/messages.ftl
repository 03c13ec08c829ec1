### Avisos, pistas y lo que puede fallar. { $path } es un archivo o una carpeta, { $details } son frases en inglés.

saved = Guardado

hint-map-raised = El mapa elevado
hint-map-horizon = El mapa del horizonte
hint-no-other-map = La esfera no tiene otro mapa.
hint-bent = { $up } curva la imagen a hiperbólica; { $down }, a esférica.
hint-unbent = La imagen vuelve a ser plana.
hint-no-bullets = No te quedan balas.
hint-no-place-for-lamp = Una lámpara necesita suelo, a ocho metros como mucho.
hint-none-there-lamp = No hay ninguna lámpara bajo la mira.
hint-too-many-lamp = Hay demasiadas lámparas en este mundo; recoge antes una.
room-hint-no-place-for-lamp = Una lámpara necesita algo en lo que apoyarse bajo la mira, a ocho metros como mucho.
room-hint-too-many-lamps = Esta sala ya tiene ocho lámparas propias, y no pueden brillar más.
room-hint-nothing-to-lift = No hay nada suelto bajo la mira a menos de tres metros.
room-hint-too-heavy = Pesa demasiado para levantarlo; empújalo.
room-hint-fell-out = Te has caído de la sala y empiezas de nuevo.
room-hint-for-worlds = { $key } es para los mundos. En una sala tienes siempre a mano la pistola, las lámparas y las pelotas.
hint-no-place-for-flag = Una bandera necesita terreno no muy empinado, a ocho metros como mucho.
hint-none-there-flag = No hay ninguna bandera bajo la mira.
hint-too-many-flag = Hay demasiadas banderas en este mundo; recoge antes una.
hint-no-place-for-log = Un tronco necesita terreno libre donde apoyarse, a ocho metros como mucho.
hint-no-place-for-stone = Una piedra necesita terreno libre donde apoyarse, a ocho metros como mucho.
hint-no-place-for-seed = Una semilla necesita terreno blando y llano, al aire libre y a un paso de otros árboles, a ocho metros como mucho.
hint-no-place-for-crumb = Una miga necesita terreno a ocho metros como mucho.
hint-none-there-crumb = No hay ninguna miga bajo la mira.
hint-last-crumb = Esa era tu última miga: tu rastro acaba aquí.
hint-too-many-crumb = Hay demasiadas migas en este mundo; recoge una primero.
hint-moved-crumb = Has recogido la primera miga y la has dejado aquí: un mundo tiene 512 como mucho.
hint-none-there-log = No hay ningún tronco bajo la mira.
hint-none-there-stone = No hay ninguna piedra bajo la mira.
hint-too-many-log = Hay demasiados troncos en este mundo; recoge antes uno.
hint-too-many-stone = Hay demasiadas piedras en este mundo; recoge antes una.
hint-too-many-seed = Aquí no se pueden plantar más árboles.
hint-no-place-for-door = No hay suelo para la puerta a menos de ocho metros.
hint-door-steep = Aquí el suelo es demasiado empinado para una puerta: busca un sitio llano, o cava o construye uno.
hint-door-walled = Aquí hay roca en medio: una puerta necesita un metro libre delante y detrás.
hint-door-crowded = La otra puerta está demasiado cerca: deja dos metros y medio entre ellas.
against-door-steep = demasiado empinado para una puerta
against-door-walled = hay roca en medio
against-door-crowded = demasiado cerca de la otra puerta
hint-none-there-door = No hay ninguna puerta bajo la mira.
hint-too-many-door = Este mundo ya tiene sus dos puertas; recoge antes una.
hint-moved-door = La puerta más antigua está ahora aquí.
hint-no-room = No puedes llevar más.
hint-too-many-drops = Ya hay demasiadas cosas tiradas; recoge antes algo.
hint-died-of-fall = Has caído desde muy alto. Te levantarás donde empezaste.
hint-died-of-shot = Te han disparado. Te levantarás donde empezaste.
hint-died-of-crash = El choque te ha matado. Te levantarás donde empezaste.
hint-died-of-car = Te ha atropellado un coche. Te levantarás donde empezaste.
hint-died-of-tree = Te ha caído un árbol encima. Te levantarás donde empezaste.
hint-no-car-near = No hay ningún coche a la vista a menos de cuatro metros.
hint-look-at-car = El coche está a tu lado. Míralo para subir.
hint-car-too-far = El coche está demasiado lejos para subir. Acércate.
hint-at-the-wheel = Al volante. Freno: { $brake } · Cámara: { $camera } · Bocina: { $horn } · Bajar: { $leave }
hint-fallen-over = El coche ha volcado. { $flip } lo pone sobre sus ruedas.
hint-no-way-out = Junto al coche no hay suelo libre donde bajar.
hint-back-again = Has vuelto al principio. Lo que llevabas sigue contigo.
hint-been-round = Has dado la vuelta al mundo, { $metres } m, y estás otra vez donde estabas.
hint-nobody-to-talk-to = Delante no hay nadie con quien hablar.
hint-too-far-to-talk = Están demasiado lejos para hablar. Acércate.
hint-waits-to-talk = Te han oído y esperan. Acércate para hablar.
hint-in-the-way = Estás en medio de lo que construyes, bajo un techo. Retrocede o usa un pincel más pequeño.
hint-out-of-reach = No hay nada que cavar al alcance. Acércate.
hint-too-hard = Demasiado duro para este pico: { $kind }. Con lo que cavas se puede hacer uno mejor.
hint-nothing-to-build = No tienes suelo con que construir. Cava primero.
hint-used-up = No queda con que construir: { $kind }. Elige otro suelo o cava más.
hint-made = Hecho: { $item }
hint-no-coal-yet = Has cavado hondo y no has encontrado carbón. Sus capas están bajo más o menos la mitad del terreno: cava unos treinta metros más allá o mira las paredes de una cueva.
hint-undone = El último trazo está deshecho.
hint-undo-none-left = No queda ningún trazo que deshacer.
hint-undo-away = El último trazo está demasiado lejos para deshacerlo. Vuelve a donde lo hiciste.
hint-undo-changed = El último trazo se queda: su suelo ha cambiado desde entonces.
hint-undo-spent = El último trazo se queda: el suelo que dio ya se ha usado.
hint-undo-unreadable = El último trazo se queda: lo guardado de su suelo no se puede leer ahora. Comprueba que el disco está y vuelve a intentarlo.

talk-triangle-flat = Puse tres lámparas, cada una a { $side } m de las otras dos. Vistas unas desde otras suman { $sum }°, como en la escuela.
talk-triangle-pictured = Puse tres lámparas, cada una a { $side } m de las otras dos. Vistas unas desde otras suman { $sum }°: la tierra es llana y solo su imagen es curva.
talk-hello = ¡Hola! { $words }
talk-triangle-more = Puse tres lámparas, cada una a { $side } m de las otras dos. Vistas unas desde otras suman { $sum }°, más de 180.
talk-triangle-less = Puse tres lámparas, cada una a { $side } m de las otras. Vistas una desde otra suman { $sum }°, menos de 180.
talk-horizon-lower = ¿Ves el suelo a { $away } m, tan alto como este? Se ve { $angle }° más abajo que en una imagen plana.
talk-horizon-flat = ¿Ves el suelo a { $away } m, tan alto como este? Está justo donde lo muestra una imagen plana.
talk-horizon-higher = ¿Ves el suelo a { $away } m, tan alto como este? Se ve { $angle }° más arriba que en una imagen plana.
talk-home-round = A casa hay { $there } m desde aquí, o { $round } m por el otro lado, dando la vuelta al mundo.
talk-home-straight = A casa hay { $there } m desde aquí. Esta tierra no tiene fin, así que no hay camino que le dé la vuelta.
talk-home-squares = Tu casa está a { $there } m, { $squares ->
    [0] en este mismo cuadrado
    [one] a { $squares } cuadrado de aquí
   *[other] a { $squares } cuadrados de aquí
}. Cualquier otro camino es más largo, y casi todos mucho más.
talk-land = A esta altura, a menos de { $within } m hay { $times } veces más tierra que en terreno plano. Más abajo hay más.
talk-square = Camina { $side } m, gira a la derecha y hazlo cuatro veces. En terreno plano estarías de vuelta; aquí acabas a { $gap } m de donde saliste.

open-failed = No se pudo abrir el mundo
open-died = Algo falló durante la lectura; el registro dice el resto.
save-failed = No se pudo guardar el mundo
close-died = Algo falló al escribir el mundo; el registro dice el resto.
not-saved = Los últimos cambios del mundo no están guardados.
not-saved-yet = No se pudo guardar el mundo; el próximo guardado lo intentará de nuevo.
save-unfinished = El último cambio del terreno o su guardado no terminó a tiempo; todo lo guardado antes está a salvo.

save-in-use = El mundo «{ $world }» está en uso: está abierto en otra ventana del juego o en otro programa. Ciérralo allí e inténtalo de nuevo.
save-newer = El mundo «{ $world }» fue guardado por una versión más nueva del juego. Actualiza el juego para jugar en él; no se ha cambiado nada.
save-damaged = Una parte de este mundo está dañada. El resto se puede usar; «antipode saves repair» recupera una copia anterior si la hay. ({ $details })
save-part-damaged = Una parte de este mundo está dañada. El resto se puede usar; «antipode saves verify» dice cuál es, y «antipode saves repair» recupera una copia anterior si la hay.
save-unreadable = La partida { $path } está dañada y no se puede leer. «antipode saves repair» rescata lo que está entero y conserva este archivo.
save-file-missing = Falta el archivo { $path } de este mundo. Si tienes una copia, devuélvela a su sitio; si no, «antipode saves repair» rehace el mundo donde puede.
save-vanished = La partida { $path } ha desaparecido: su carpeta se movió, borró o reemplazó con el mundo abierto, así que no se puede guardar nada allí. Devuelve la carpeta a su sitio y guarda de nuevo.
save-not-found = Ya no hay ningún mundo «{ $world }».
saves-busy = Otro juego está creando, renombrando o importando un mundo en { $path } y no termina. Inténtalo de nuevo en un momento o cierra el otro juego.
saves-not-a-folder = { $path } es un archivo, así que no puede contener mundos. Elige una carpeta con --saves-dir.
file-exists = { $path } ya existe y no se sobrescribe. Elige otro nombre o muévelo.
disk-full = No queda espacio para escribir { $path }. Libera espacio y guarda de nuevo; lo guardado antes está a salvo.
not-writable = No se puede escribir { $path }: es de solo lectura o pertenece a otra persona. Cambia sus permisos o elige otro lugar con --saves-dir.
not-readable = No se puede leer { $path }: los permisos lo prohíben o pertenece a otra persona. Cambia los permisos o elige otro lugar con --saves-dir.
archive-refused = No se puede importar { $path }: no es un mundo exportado o está dañado. El registro dice el resto.
unknown-space = El mundo «{ $world }» está en un espacio que esta versión no conoce. Una versión más nueva del juego quizá lo abra.
unknown-generator = El terreno del mundo «{ $world }» se hace de un modo que esta versión no conoce. Una versión más nueva del juego quizá lo abra.
impossible-radius = El mundo «{ $world }» dice que su espacio tiene un radio de { $radius } m, y ningún mundo puede tenerlo. Su archivo quedó como está.
player-damaged = El jugador de la partida estaba dañado; empiezas de nuevo desde el principio. Tu tierra está como estaba.
unknown-item = La partida contiene un objeto que esta versión no conoce («{ $item }»); no se muestra, pero sigue en la partida.
unknown-records = { $count ->
    [one] La partida contiene una cosa de una versión más nueva; no se muestra, pero sigue en la partida.
   *[other] La partida contiene { $count } cosas de una versión más nueva; no se muestran, pero siguen en la partida.
}
unknown-map = La partida nombra un mapa que esta versión no conoce («{ $map }»); se muestra otro.
more-damaged = { $count ->
    [one] Hay un lugar dañado más en este mundo; «antipode saves verify» lo muestra.
   *[other] Hay { $count } lugares dañados más en este mundo; «antipode saves verify» los muestra.
}
land-trouble = Algo va mal con la tierra. { $details }
other-trouble = Eso no ha funcionado. { $details }

name-empty = Ponle un nombre al mundo.
name-blank = El nombre necesita al menos un carácter visible.
name-too-long = { $chars ->
    [one] El nombre tiene un carácter; caben { $most } como máximo.
   *[other] El nombre tiene { $chars } caracteres; caben { $most } como máximo.
}
name-unprintable = El nombre contiene un carácter que no se puede mostrar ({ $code }).
name-taken = Ya hay un mundo llamado «{ $name }».
room-name-taken = Ya hay una sala llamada «{ $name }».

no-adapter = No se encontró en este equipo ninguna tarjeta gráfica que el juego pueda usar ({ $found }). Instala su controlador o inicia el juego con --adapter software.
adapter-lost = Se perdió la tarjeta gráfica. Tu mundo está a salvo; inicia el juego de nuevo.
adapter-refuses = La tarjeta gráfica rechaza un shader del juego ({ $details }). Actualiza su controlador o inicia el juego con --adapter software.
adapter-reopened = Se perdió la tarjeta gráfica y se ha vuelto a abrir.

# Why the game was started anew after its graphics had failed for good, and what draws now.
graphics-title = Los gráficos han fallado
graphics-lost = Se perdió la tarjeta gráfica y no se pudo volver a abrir. Tu mundo está guardado.
graphics-software = El juego se ha vuelto a iniciar y ahora dibuja el procesador, que es más lento. Para probar otra vez con la tarjeta gráfica, sal del juego e inícialo de nuevo.

# Un fallo de la ejecución anterior.
crash-title = El juego ha fallado
crash = El juego se detuvo de forma inesperada y se ha vuelto a iniciar. Tus mundos y salas están como se guardaron por última vez, a lo sumo unos segundos antes. Lo que se sabe del fallo está en { $report }.

# Biomas: al entrar en uno se muestra solo el nombre.
biome-volcanic = Tierra volcánica
biome-desert = Desierto
biome-forest = Bosque
biome-toxic = Llanura tóxica
biome-jungle = Jungla
biome-tundra = Tundra
biome-wetland = Humedal
biome-crags = Peñas
biome-shore = Costa
biome-cave = Cueva
