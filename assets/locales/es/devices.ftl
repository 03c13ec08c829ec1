### Sonido y mandos. Claves formadas al ejecutar: setting-<id>, key-<id>.

settings-group-sound = Sonido
settings-group-pad = Mando
unit-percent = { $value } %
unit-degrees-per-second = { $value }° por segundo

setting-volume-master = Volumen
setting-volume-master-about = De todo junto.
setting-volume-effects = Pasos y herramientas
setting-volume-effects-about = Cuánto suenan los pasos, las caídas, cavar y construir.
setting-volume-ambience = Viento, día y noche
setting-volume-ambience-about = Cuánto suena el viento, y los pájaros de día y los grillos de noche.
setting-volume-music = Música
setting-volume-music-about = Cuánto suena la música; es tranquila y tiene largas pausas.
setting-volume-interface = Menús y barra
setting-volume-interface-about = Cuánto suenan los menús y la barra de objetos.
setting-mute-elsewhere = Silencio en segundo plano
setting-mute-elsewhere-about = No se oye nada mientras otra ventana tiene el teclado.
setting-pad-look-speed = Giro con la palanca
setting-pad-look-speed-about = Con qué rapidez gira la vista con la palanca derecha al máximo.
setting-pad-invert-look = Invertir arriba y abajo de la palanca
setting-pad-invert-look-about = Empujar la palanca derecha mira hacia abajo, como en un avión.
setting-pad-dead-zone = Reposo de las palancas
setting-pad-dead-zone-about = Cuánto puede apartarse una palanca de su centro y contar aún como suelta. Más ayuda si la vista gira sola.

sound-none = No hay dispositivo de sonido; el juego sigue sin él. Si se conecta uno, se usará.
sound-lost = El dispositivo de sonido ya no está; el juego sigue sin él y espera otro.
sound-left-out = Este juego se construyó sin sonido.

pad-connected = Mando conectado: { $name }
pad-disconnected = Mando desconectado: { $name }

key-pad-south = Mando A, abajo
key-pad-east = Mando B, derecha
key-pad-west = Mando X, izquierda
key-pad-north = Mando Y, arriba
key-pad-left-bumper = Mando LB, izquierda
key-pad-right-bumper = Mando RB, derecha
key-pad-left-trigger = Mando LT, izquierda
key-pad-right-trigger = Mando RT, derecha
key-pad-select = Mando Select
key-pad-start = Mando Start
key-pad-left-stick = Mando L3, izquierda
key-pad-right-stick = Mando R3, derecha
key-pad-up = Mando cruceta arriba
key-pad-down = Mando cruceta abajo
key-pad-left = Mando cruceta izquierda
key-pad-right = Mando cruceta derecha
