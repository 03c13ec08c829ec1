### La pantalla sobre el mundo.

display-chart = carta
display-curved = modelo
display-flat = espacio plano: lo mismo
display-loading = La tierra está llegando: { $percent } %
display-hemisphere = Hemisferio { $letter }
display-brush = Pincel { $radius } m
display-speed = { $speed } km/h

compass-north = N
compass-east = E
compass-south = S
compass-west = O
compass-equator = { $letter } · ecuador { $metres } m
compass-home = Casa { $metres } m · { $squares ->
    [0] este cuadrado
    [one] { $squares } cuadrado
   *[other] { $squares } cuadrados
}
compass-flag = { $name } · { $metres } m
compass-way-back = Camino de vuelta
display-sighting = Tres banderas: { $here }° + { $seen }° + { $third }° = { $sum }° · lados { $a }, { $b }, { $c } m

dial-raised = Curvatura, elevada
dial-horizon = Curvatura, horizonte
dial-bend-hyperbolic = Flexión, hiperbólica
dial-bend-spherical = Flexión, esférica
dial-bend-flat = Flexión, plana

space-hyperbolic = lente hiperbólica
space-hyperbolic-world = mundo hiperbólico
space-euclidean = euclídeo
space-spherical = esférico

item-pickaxe-wood = Pico de madera
item-pickaxe-iron = Pico de hierro
item-pickaxe-diamond = Pico de diamante
item-gun = Pistola
item-bullet = Bala
item-lamp = Lámpara
item-flag = Bandera
item-door = Puerta
item-log = Tronco
item-stone = Piedra
item-seed = Semilla
item-crumb = Miga de pan
flag-unnamed = Bandera { $number }
flag-name-title = ¿Cómo se llama esta bandera?
flag-name = Nombre de la bandera
flag-name-keep = Dejarla así

figures-fps = { $frames } fps
figures-fps-unknown = fps n/d
figures-ms = { $ms } ms
figures-unknown = n/d
figures-times = { $fps }   cuadro { $frame }   GPU { $gpu }   { $time }
figures-comma = { ", " }
figures-chunks = trozos
figures-chunks-are = { $frame } enteros, { $vertex } por vértices, { $refined } refinados
figures-detail = detalle
figures-detail-is = { $full } entero, { $half } mitad, { $quarter } cuarto, { $eighth } octavo
figures-drawn = dibujo
figures-drawn-are = { $triangles } triángulos
figures-saved = omitidos
figures-saved-are = { $outside } fuera, { $hidden } ocultos, { $small } demasiado pequeños
figures-error = error
figures-error-is = { $most } px como máximo, tierra lejana { $far } px
figures-dropped = omitido
figures-dropped-is = { $seconds } s de tiempo
picture-raised = mapa elevado { $value }
picture-horizon = mapa del horizonte { $value }
picture-bend = flexión { $sign }{ $value }
quality-fast = rápida
quality-balanced = equilibrada
quality-exact = exacta

# In rooms: how far off what is under the crosshair is, and how large one is.
room-ahead = { $felt } m
room-ahead-bent = { $felt } m a pie, { $scene } m desde fuera
room-smaller = Aquí eres { $times } veces más pequeño que fuera
room-larger = Aquí eres { $times } veces más grande que fuera
room-smaller-level = A lo largo del suelo eres aquí { $times } veces más pequeño que fuera
room-larger-level = A lo largo del suelo eres aquí { $times } veces más grande que fuera
room-smaller-up = En altura eres aquí { $times } veces más pequeño que fuera
room-larger-up = En altura eres aquí { $times } veces más grande que fuera
room-smaller-began = Eres { $times } veces más pequeño que al principio
room-larger-began = Eres { $times } veces más grande que al principio
room-keys = { $look }: la vista exacta o la de la tesis · { $camera }: desde atrás · { $gun }: disparar · { $lamp }: poner o recoger una lámpara · { $lift }: levantar o dejar lo suelto · { $ball }: lanzar una pelota · { $anew }: empezar de nuevo · { $again }: esto otra vez · { $edges }: aristas de las cajas
room-keys-own = { $build }: construir aquí
# The ways to look at a room, and what differs in the middle of the picture.
room-look-split = A la izquierda según la tesis, el primer intento de tales salas; a la derecha exacto
room-look-thesis = Según la regla de la tesis, el primer intento de tales salas
room-look-plain = Como en el plano: nada está estirado ni doblado
room-half-thesis = tesis
room-half-exact = exacto
room-differs = En el centro: { $exact }, y según la tesis { $thesis }.
room-differs-bent = En el centro: { $exact }, y según la tesis { $thesis }, adonde la luz llega doblada { $bent }°.
room-sky = el cielo
room-own = Esta sala es tuya.
display-brush-shape = { $shape } { $radius } m
display-heap = { $sign }{ $volume } m³ { $kind }
display-ground-left = { $kind }, quedan { $volume } m³
ground-none = Nada todavía
ground-found = Como estaba
ground-grass = Hierba
ground-soil = Tierra
ground-sand = Arena
ground-gravel = Grava
ground-rock = Roca
ground-ash = Ceniza
ground-snow = Nieve
ground-moss = Musgo
ground-clay = Arcilla
ground-basalt = Basalto
ground-slate = Pizarra
ground-coal = Carbón
ground-copper = Cobre
ground-crystal = Cristal
ground-wood = Madera
brush-ball = Esfera
brush-box = Cubo
brush-cylinder = Cilindro
brush-flatten = Aplanar
brush-smooth = Suavizar
