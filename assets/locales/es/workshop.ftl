### El taller, en el que se construyen salas.

# Salas para construir.
workshop-rooms-none = Aún no tienes salas propias. Crea una nueva o duplica una del juego en su página (los tres puntos). La primera viene con una lección.
workshop-rooms-shipped = Salas del juego
workshop-rooms-load = Construir
workshop-rooms-load-named = Construir en «{ $name }»
workshop-not-own = Esta sala viene con el juego. Duplícala y construye en la copia.
workshop-not-kept = No se pudo guardar la sala: { $reason }
workshop-not-saved-yet = Tus cambios están guardados, pero el archivo de la sala queda como estaba hasta que se arregle esto: { $reason }
workshop-kept = La sala se está guardando. También se guarda sola: cada paso en menos de dos segundos.

# Paneles.
workshop-pane-view = Vista
workshop-pane-list = Objetos
workshop-pane-inspector = Propiedades
workshop-pane-parts = Piezas
workshop-pane-messages = Mensajes
workshop-pane-history = Historial
workshop-search = Buscar
workshop-none-found = Nada se llama así.
workshop-rename = Nombre nuevo
workshop-hide = Ocultar «{ $name }»
workshop-fold = Plegar «{ $name }»
workshop-lock = Bloquear «{ $name }»
workshop-reset = Restablecer { $name }
workshop-parts-hint = Un clic pone una pieza sobre lo que miras.
workshop-all-well = Esta sala no tiene ningún problema.
workshop-note-ahead = Los últimos cambios de esta sala no habían llegado a su archivo cuando terminó el juego. Han vuelto; no hay nada que hacer.
workshop-note-changed = Otra cosa ha cambiado el archivo de esta sala desde que se guardó aquí. Ese es el último paso del historial; deshazlo para tener la sala como estaba.
workshop-note-aside = El diario de esta sala estaba dañado y se apartó como { $file }. Pueden faltar pasos antiguos; «Versiones anteriores» en el historial muestra qué más se conserva.
workshop-in-use = Otra ventana del juego está construyendo en esta sala. Aquí puedes recorrerla; ciérrala allí primero para construir aquí.
workshop-no-journal = No se puede escribir en la carpeta de esta sala ({ $reason }). Puedes recorrerla; para construir, permite escribir en su carpeta y entra de nuevo.
workshop-drop-elsewhere = Puedes soltar archivos en una sala mientras construyes en ella: Taller en el menú principal, o F5 en una sala tuya.
workshop-drop-choose = Elige primero sobre qué debe ir la imagen y tráela otra vez.
workshop-older = Versiones anteriores
workshop-older-about = Un clic pone esa versión en lugar de la sala. Es un paso y se puede deshacer.
workshop-older-none = Aún no hay versiones anteriores. Medio minuto después de un cambio se guarda una.
workshop-beginning = El comienzo
workshop-room-itself = La sala misma
workshop-one = { $name } ({ $kind })
workshop-several = { $count ->
    [one] { $count } objeto
   *[other] { $count } objetos
}
workshop-status-nothing = Haz clic en algo, o vuela: mantén el botón derecho y W A S D, E, Q.
workshop-status-chosen = Arrástralo o un tirador · flechas: un paso · F: mirarlo · Alt: sin rejilla
workshop-status-turn = Arrastra un aro: pasos de 15° · F: mirarlo · Alt: sin rejilla
workshop-status-scale = Arrastra un tirador: el otro lado no se mueve · F: mirarlo · Alt: sin rejilla
workshop-status-scale-whole = Arrastra un tirador: crece todo · F: mirarlo
workshop-status-flies = W A S D, E y Q vuelan, las flechas giran. V o Esc termina.
workshop-status-late = Dibujando de nuevo…
workshop-outside-inside = { $outside } m por fuera, { $inside } m por dentro

# Lo que se hace.
workshop-do-play = Jugar
workshop-do-leave = Salir de la sala
workshop-do-undo = Deshacer
workshop-do-redo = Rehacer
workshop-do-move = Mover
workshop-do-turn = Girar
workshop-do-scale = Escalar
workshop-do-own-axes = Ejes propios
workshop-do-snaps = Rejilla
workshop-do-on-surfaces = En superficies
workshop-do-copy = Copiar
workshop-do-cut = Cortar
workshop-do-paste = Pegar
workshop-do-duplicate = Duplicar
workshop-do-array = Repetir en fila
workshop-do-group = Agrupar
workshop-do-ungroup = Desagrupar
workshop-do-delete = Eliminar
workshop-do-choose-all = Seleccionar todo
workshop-do-focus = Mirar la selección
workshop-do-top = Desde arriba
workshop-do-front = De frente
workshop-do-side = De lado
workshop-do-start = Desde el inicio
workshop-do-flies = Volar con teclas
workshop-do-raster = Primero una imagen rápida
workshop-grid = { $metres } m
workshop-menu-edit = Editar
workshop-menu-room = Sala
workshop-menu-view = Vista
workshop-key-ctrl = Ctrl
workshop-key-shift = Mayús

# Unidades.
workshop-unit-metres = { $value } m
workshop-unit-degrees = { $value }°
workshop-unit-times = × { $value }
workshop-unit-plain = { $value }

# Clases de objetos.
workshop-kind-box = caja
workshop-kind-pyramid = pirámide
workshop-kind-ramp = rampa
workshop-kind-cylinder = cilindro
workshop-kind-ball = bola
workshop-kind-stairs = escalera
workshop-kind-arch = arco
workshop-kind-model = modelo
workshop-kind-light = lámpara
workshop-kind-aberration = espacio
workshop-kind-portal = portal
workshop-kind-sign = letrero
workshop-kind-group = grupo

# Piezas.
workshop-part-box = Caja
workshop-about-box = Un bloque de un metro.
workshop-part-wall = Pared
workshop-about-wall = 4 m de ancho, 2,5 m de alto.
workshop-part-floor = Suelo
workshop-about-floor = Una losa de 4 por 4 m.
workshop-part-pyramid = Pirámide
workshop-about-pyramid = Con la punta hacia arriba.
workshop-part-ramp = Rampa
workshop-about-ramp = Sube hacia delante.
workshop-part-stairs = Escalera
workshop-about-stairs = Ocho peldaños hasta 2 m.
workshop-part-arch = Arco
workshop-about-arch = Un bloque con una puerta.
workshop-part-cylinder = Cilindro
workshop-about-cylinder = De pie, 2 m de alto.
workshop-part-ball = Bola
workshop-about-ball = Una bola de un metro.
workshop-part-light = Lámpara
workshop-about-light = Luz desde un punto; como máximo ocho por sala.
workshop-part-sign = Letrero
workshop-about-sign = Un tablero para leer.
workshop-part-tunnel = Túnel
workshop-about-tunnel = 4 m por fuera, 20 m por dentro, con paredes propias. Dentro nada se curva.
workshop-part-hall = Espacio mayor
workshop-about-hall = Una caja abierta, el doble de grande por dentro. Quien entra es la mitad de grande. Ponle paredes o usa la casa.
workshop-part-portals = Par de portales
workshop-about-portals = Quien entra por uno sale por el otro.

# Propiedades.
workshop-field-name = Nombre
workshop-field-at = Lugar
workshop-field-at-group = Lugar en el grupo
workshop-field-turn = Giro (sobre y, z, x)
workshop-field-size = Tamaño
workshop-field-radius = Radio
workshop-field-height = Altura
workshop-field-steps = Peldaños
workshop-field-opening = Puerta
workshop-field-scale = Escala
workshop-field-text = Texto
workshop-field-colour = Color
workshop-field-power = Brillo
workshop-field-checker = A cuadros
workshop-field-checker-colour = Segundo color
workshop-field-checker-size = Lado del cuadro
workshop-field-texture-file = Imagen
workshop-texture-none = Puede llevar una imagen: Ctrl+O.
workshop-field-texture-size = Lado de la imagen
workshop-field-finish = Acabado
workshop-field-glow = Brillo propio
workshop-field-box = Tamaño por fuera
workshop-field-lengths = Qué estira
workshop-field-axis = Eje
workshop-field-felt = Longitud por dentro
workshop-field-times = Estiramiento
workshop-field-times-x = Estiramiento en x
workshop-field-times-y = Estiramiento en y
workshop-field-times-z = Estiramiento en z
workshop-field-thesis = d de la tesis
workshop-field-sides = Lados
workshop-field-ways = Actúa sobre
workshop-field-outline = Se ven los bordes
workshop-field-to = Lleva a
workshop-field-sentence = Qué hay de extraño
workshop-field-spawn-at = Inicio
workshop-field-spawn-look = Mirada al inicio (giro, inclinación)
workshop-field-gravity = Gravedad
workshop-field-sky = Cielo
workshop-field-light = Luz ambiental
workshop-field-has-sun = Sol
workshop-field-sun = Dónde está
workshop-field-sun-colour = Color del sol
workshop-field-sun-power = Brillo del sol
workshop-field-has-fog = Niebla
workshop-field-fog = No se ve nada desde
workshop-field-fog-colour = Color de la niebla
workshop-choice-finish-matt = Mate
workshop-choice-finish-mirror = Espejo
workshop-choice-finish-glass = Vidrio
workshop-choice-lengths-felt = Un eje
workshop-choice-lengths-stretch = Todos los ejes
workshop-choice-axis-x = x (rojo)
workshop-choice-axis-y = y (verde)
workshop-choice-axis-z = z (azul)
workshop-choice-sides-walls = Paredes
workshop-choice-sides-soft = Abiertos
workshop-choice-sides-snell = Refractante
workshop-choice-sides-legacy = Regla de la tesis
workshop-choice-sides-1 = Un lado
workshop-choice-sides-2 = Ambos lados
workshop-choice-ways-both = Todos los que entran
workshop-choice-ways-forward = Solo quien va según el eje

# Lo que hace el espacio.
workshop-told-felt = Por fuera mide { $outside } m y por dentro { $inside } m: { $seconds } s a pie en vez de { $before }.
workshop-told-smaller = Quien entra es { $times } veces menor, así que todo es otras tantas veces mayor. Eso no curva la vista.
workshop-told-larger = Quien entra es { $times } veces mayor, así que todo es otras tantas veces menor. Eso no curva la vista.
workshop-told-walls = Tiene paredes propias; nada se curva y sus puertas son iguales por dentro y por fuera.
workshop-told-soft = Las direcciones no cambian al cruzar una cara: se llega a lo que se ve.
workshop-told-snell = La luz se refracta como en el vidrio y, pasado un ángulo, se refleja.
workshop-told-legacy = La regla de la tesis tiene fallos: lo que se ve depende de hacia dónde se mira, y no se llega a ello.
workshop-told-no-door = Las paredes no dejan puerta si se estira más de un eje. Estira uno solo o haz los lados abiertos.
workshop-told-astigmatic = A través de ella las rectas se ven curvas, porque sus lados se estiran de forma desigual.
workshop-told-grazing = A lo largo de sus lados todo se ve comprimido.
workshop-told-itself = Lleva a sí mismo: muestra a quien mira.
workshop-told-alike = Es tan grande como «{ $name }»: quien pasa conserva su tamaño.
workshop-told-grows = Quien va a «{ $name }» se hace { $times } veces mayor.
workshop-told-shrinks = Quien va a «{ $name }» se hace { $times } veces menor.

# Pasos del historial.
workshop-step-add = { $count ->
    [one] Añadir «{ $name }»
   *[other] Añadir { $count } objetos
}
workshop-step-remove = { $count ->
    [one] Eliminar «{ $name }»
   *[other] Eliminar { $count } objetos
}
workshop-step-move = { $count ->
    [one] Mover «{ $name }»
   *[other] Mover { $count } objetos
}
workshop-step-turn = { $count ->
    [one] Girar «{ $name }»
   *[other] Girar { $count } objetos
}
workshop-step-pose = { $count ->
    [one] Colocar «{ $name }»
   *[other] Colocar { $count } objetos
}
workshop-step-resize = { $count ->
    [one] Tamaño de «{ $name }»
   *[other] Tamaño de { $count } objetos
}
workshop-step-stretch = { $count ->
    [one] Estirar «{ $name }»
   *[other] Estirar { $count } objetos
}
workshop-step-sides = { $count ->
    [one] Lados de «{ $name }»
   *[other] Lados de { $count } objetos
}
workshop-step-surface = { $count ->
    [one] Superficie de «{ $name }»
   *[other] Superficie de { $count } objetos
}
workshop-step-link = { $count ->
    [one] Enlazar «{ $name }»
   *[other] Enlazar { $count } portales
}
workshop-step-text = { $count ->
    [one] Texto de «{ $name }»
   *[other] Texto de { $count } letreros
}
workshop-step-light = { $count ->
    [one] Luz de «{ $name }»
   *[other] Luz de { $count } lámparas
}
workshop-step-change = { $count ->
    [one] Cambiar «{ $name }»
   *[other] Cambiar { $count } objetos
}
workshop-step-rename = Renombrar «{ $name }» a «{ $new }»
workshop-step-group = Agrupar «{ $name }»
workshop-step-carry = { $count ->
    [one] Sacar «{ $name }» del grupo
   *[other] Sacar { $count } objetos de grupos
}
workshop-step-ungroup = { $count ->
    [one] Desagrupar «{ $name }»
   *[other] Desagrupar { $count } grupos
}
workshop-step-duplicate = { $count ->
    [one] Duplicar «{ $name }»
   *[other] Duplicar { $count } objetos
}
workshop-step-array = { $count ->
    [one] Repetir «{ $name }»
   *[other] Repetir { $count } objetos
}
workshop-step-paste = { $count ->
    [one] Pegar «{ $name }»
   *[other] Pegar { $count } objetos
}
workshop-step-room = La sala misma
workshop-step-spawn = El inicio
workshop-step-several = Varios cambios
workshop-step-outside = Cambiada fuera del juego
workshop-step-version = Versión { $when }

# Lo que puede estar mal.
workshop-finding-not-parallel = «{ $name }» está en parte dentro de «{ $other }» y girada de otro modo; está cerrada hasta que sus ejes sean paralelos o una esté del todo en la otra.
workshop-finding-too-deep = «{ $name }» está en demasiados espacios estirados anidados, entre ellos «{ $other }»; ocho es el máximo.
workshop-finding-walls-across = Una pared de «{ $name }» atraviesa «{ $other }» y cierra el paso; aparta una de las dos.
workshop-finding-same-place = «{ $name }» está en el mismo lugar que «{ $other }»; muévela o quítala.
workshop-finding-tangled = «{ $name }» está en tantas otras que no se sabe a qué profundidad; separa algunas.
workshop-finding-no-door = «{ $name }» tiene paredes en los seis lados y nadie podría entrar.
workshop-finding-out-of-range = «{ $name }» tiene un número fuera de rango.
workshop-finding-no-partner = El portal «{ $name }» no lleva a ninguna parte: no existe el portal al que lleva.
workshop-finding-one-way = El portal «{ $name }» lleva a «{ $other }», que no lleva de vuelta.
workshop-finding-other-sides = «{ $name }» y «{ $other }» no tienen los mismos lados.
workshop-finding-not-similar = «{ $name }» no es semejante a su pareja «{ $other }»: dales tamaños proporcionales.
workshop-finding-other-size = «{ $name }» difiere de su pareja «{ $other }» en más de 32 veces.
workshop-finding-portal-shape = Las esquinas de «{ $name }» no forman una figura convexa.
workshop-finding-over-side = El portal «{ $name }» está sobre un lado de «{ $other }»; ponlo del todo dentro o fuera.
workshop-finding-in-odd-box = El portal «{ $name }» está en «{ $other }», donde no puede haber portales.
workshop-finding-portals-touch = Los portales «{ $name }» y «{ $other }» se tocan; sepáralos al menos un milímetro.
workshop-finding-spawn-in-solid = El inicio está dentro de «{ $name }».
workshop-finding-spawn-in-air = { $metres ->
    [0] Se empieza sobre la nada y se cae de la sala.
    [one] Se empieza en el aire y se cae { $metres } m.
   *[other] Se empieza en el aire y se caen { $metres } m.
}
workshop-finding-open-sides = Los lados de «{ $name }» están abiertos: allí la luz se curva. Cúbrelos o ponle paredes.
workshop-finding-fall-out = Se puede caer de la sala tras andar { $metres } m.
workshop-finding-unreached = No se puede llegar a pie a «{ $name }» desde donde se empieza.

# Help, and parts of several things.
workshop-reset-short = restablecer
workshop-menu-help = Ayuda
workshop-do-lesson = Hacer la lección
workshop-do-examples = Lo que es posible
workshop-do-parallel = Sin perspectiva
workshop-do-walls = Ocultar paredes de túneles
workshop-field-times-all = Estiramiento de todos los ejes
workshop-field-group = En el grupo
workshop-choice-group-none = Ninguno
workshop-part-house = Casa mayor por dentro
workshop-about-house = Una casa de 4 m con una puerta. Por dentro es el doble de grande, y quien entra, la mitad.

# The lesson.
workshop-lesson-title = Lección, paso { $number } de { $of }
workshop-lesson-put = Haz clic en «Casa mayor por dentro» entre las piezas: quedará delante de ti.
workshop-lesson-move = Arrastra la casa un poco a un lado con el botón izquierdo.
workshop-lesson-choose = Haz clic en «{ $name }» en la lista de objetos: es el espacio de la casa.
workshop-lesson-stretch = Lleva «Estiramiento de todos los ejes» a la derecha: la casa crece por dentro y por fuera queda igual.
workshop-lesson-enter = Pulsa Jugar (F5) y entra por la puerta.
workshop-lesson-walk = Entra en la casa por la puerta. F5 lleva de vuelta al taller.
workshop-lesson-walk-tunnel = Recorre el túnel y cuenta tus pasos. F5 lleva de vuelta al taller.
workshop-lesson-done = Has construido una casa mayor por dentro. De vuelta en el taller (F5), la ayuda tiene una segunda lección, de túneles y portales, y muestra qué más es posible.
workshop-lesson-skip = Omitir este paso
workshop-lesson-end = Terminar la lección

# What is possible.
workshop-examples-title = Lo que es posible
workshop-examples-about = Cada uno puede copiarse en tu sala y cambiarse allí.
workshop-examples-copy = Copiar en la sala
workshop-examples-copy-named = Copiar «{ $name }» en la sala
workshop-examples-close = Cerrar
workshop-example-tunnel-longer = Túnel más largo por dentro
workshop-example-tunnel-longer-about = 4 m por el lado, 20 m por dentro.
workshop-example-tunnel-shorter = Túnel más corto por dentro
workshop-example-tunnel-shorter-about = 16 m por el lado, 2 m por dentro.
workshop-example-house = Casa mayor por dentro
workshop-example-house-about = Cuatro metros por fuera, ocho por dentro.
workshop-example-portals = Par de portales
workshop-example-portals-about = Quien entra por uno sale por el otro.
workshop-example-portals-of-size = Portales de distinto tamaño
workshop-example-portals-of-size-about = Quien sale del grande es tres veces más grande.
workshop-example-falling-loop = Una caída sin fin
workshop-example-falling-loop-about = Lo que cae abajo sale arriba.

# Partners of portals.
workshop-link-to = Arrástralo hasta otro portal.
workshop-link-partner = Lleva a «{ $name }»: arrastra a otro
workshop-told-no-partner = No lleva a ninguna parte y está cerrado: elige el portal al que lleva.
workshop-told-one-way = Está cerrado: «{ $name }» no lleva de vuelta.
workshop-told-other-sides = Está cerrado: «{ $name }» tiene otro número de lados.
workshop-told-not-similar = Está cerrado: «{ $name }» tiene otra forma. Da a ambos la misma proporción de ancho y alto.
workshop-told-ill-placed = Está cerrado: él o «{ $name }» está donde no puede estar. Los mensajes dicen por qué.

# Files from the disk.
workshop-do-from-file = Modelo o imagen de un archivo
workshop-do-keep = Guardar ahora
workshop-chooser-title = Un modelo o una imagen
workshop-chooser-about = Un modelo (glb, gltf, fbx, obj) quedará delante de ti; una imagen (png, jpg), sobre lo seleccionado.
workshop-chooser-path = Ruta
workshop-chooser-open = Abrir
workshop-chooser-up = Carpeta superior
workshop-chooser-home = Mi carpeta
workshop-chooser-close = Cancelar
workshop-chooser-reading = Se está leyendo la carpeta.
workshop-chooser-empty = Aquí no hay carpetas, modelos ni imágenes.
workshop-chooser-folder = carpeta
workshop-chooser-unread = { $path } no se puede leer ({ $reason }). Escribe otra ruta o sigue desde la carpeta de abajo.
workshop-chooser-unfit = { $path } no es un modelo (glb, gltf, fbx, obj) ni una imagen (png, jpg). Guárdalo como uno de estos o elige otro archivo.
workshop-chooser-many = Se muestran los primeros { $shown } de { $count }; escribe la ruta de otro.

# What fields do, where the pointer rests.
workshop-hover-sides = Qué hay en las caras por las que nadie debe pasar: paredes, nada o algo como vidrio.
workshop-hover-ways = Quien llega por el otro extremo puede hallar el espacio tan largo como parece.
workshop-hover-outline = Los bordes de la caja se ven también en el juego, no solo aquí.
workshop-hover-lengths = Un eje hace un túnel más largo o más corto; todos los ejes hacen una sala mayor o menor por dentro.
workshop-hover-thesis = Así cuenta el estiramiento una tesis, el primer programa de salas así, al revés: un metro dentro ocupa 1 + d metros fuera. 0 no cambia nada, 2 es dentro un tercio de largo, −0,8 cinco veces más largo.

# The second lesson, and a portal alone.
workshop-do-lesson-doors = Lección: túnel y portales
workshop-part-portal = Portal
workshop-about-portal = Lleva a sí mismo hasta que se arrastra una línea de él a otro.
workshop-lesson-tunnel = Haz clic en «Túnel» entre las piezas: quedará delante de ti.
workshop-lesson-longer = Con «{ $name }» seleccionado lleva «Estiramiento» a la derecha: se alarga por dentro y por fuera queda igual.
workshop-lesson-portal = Haz clic en «Portal» entre las piezas: es el primero de dos.
workshop-lesson-portal-again = Haz clic otra vez en «Portal»: el segundo queda junto al primero.
workshop-lesson-link = Arrastra desde el botón sobre «{ $name }» hasta el centro de «{ $other }»: llevarán el uno al otro.
workshop-lesson-through = Pulsa Jugar (F5) y recorre el túnel.
workshop-lesson-pass = Pulsa Jugar (F5) y entra en un portal: sales por el otro.
workshop-lesson-walk-doors = Ese era el túnel. Ahora entra en un portal. F5 lleva de vuelta al taller.
workshop-lesson-done-doors = Has construido un túnel más largo por dentro y dos portales que llevan el uno al otro. En el taller (F5), la ayuda muestra qué más es posible.
workshop-link-itself = Lleva a sí mismo: arrastra a otro portal
workshop-link-nowhere = No lleva a ninguna parte: arrastra a un portal
workshop-hover-own-axes = Los tiradores siguen los ejes del objeto, no los de la sala.
workshop-hover-snaps = Se mueve por pasos de la cuadrícula y se gira de 15° en 15°. Con Alt, sin pasos.
workshop-hover-on-surfaces = Lo que se arrastra se posa en la superficie bajo el puntero: suelos, paredes, techos.

# What parts and their things are called in a room.
workshop-name-bottom = abajo
workshop-name-top = arriba
workshop-name-falling-loop = bucle de caída
workshop-name-falling-loop-lintel = dintel del bucle
workshop-name-falling-loop-pillar = pilar del bucle
workshop-name-falling-loop-rim = borde del bucle
workshop-name-house = casa
workshop-name-house-back = casa - fondo
workshop-name-house-ceiling = casa - techo
workshop-name-house-floor = casa - suelo
workshop-name-house-front = casa - frente
workshop-name-house-inside = casa - interior
workshop-name-house-lamp = casa - lámpara
workshop-name-house-left = casa - izquierda
workshop-name-house-light = casa - luz
workshop-name-house-lining-back = casa - forro del fondo
workshop-name-house-lining-front = casa - forro del frente
workshop-name-house-lining-left = casa - forro izquierdo
workshop-name-house-lining-right = casa - forro derecho
workshop-name-house-right = casa - derecha
workshop-name-house-roof = casa - tejado
workshop-name-large-portal = portal grande
workshop-name-large-portal-frame = marco de portal grande
workshop-name-left-post = poste izquierdo
workshop-name-lintel = dintel
workshop-name-long-tunnel = túnel largo
workshop-name-long-tunnel-inside = túnel largo - interior
workshop-name-long-tunnel-slab = túnel largo - losa
workshop-name-portal = portal
workshop-name-portal-frame = marco de portal
workshop-name-right-post = poste derecho
workshop-name-short-tunnel = túnel corto
workshop-name-short-tunnel-inside = túnel corto - interior
workshop-name-short-tunnel-slab = túnel corto - losa
workshop-name-small-portal = portal pequeño
workshop-name-small-portal-frame = marco de portal pequeño
workshop-name-tunnel = túnel
workshop-name-hall = espacio
workshop-name-box = caja
workshop-name-wall = pared
workshop-name-floor = suelo
workshop-name-stairs = escalera
workshop-name-ramp = rampa
workshop-name-arch = arco
workshop-name-pyramid = pirámide
workshop-name-cylinder = cilindro
workshop-name-ball = bola
workshop-name-light = luz
workshop-name-sign = letrero
workshop-name-group = grupo
workshop-name-model = modelo
workshop-told-carried = Todo lo que lleva mide { $x } m de ancho, { $y } m de alto y { $z } m de fondo.

# The form of how something is repeated in a row.
workshop-array-count = Cuántas veces
workshop-array-axis = A lo largo de
workshop-array-gap = Libre entre medias
workshop-array-turn = Giro de cada una
workshop-array-make = Crear
workshop-array-close = Cerrar
workshop-misread = «{ $text }» no es un número: queda como estaba.
