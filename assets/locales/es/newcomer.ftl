### Hints for newcomers, shown one after another in the first world.

hints-look = Mira a tu alrededor: { $key }
hints-walk = Caminar: { $key }
hints-jump = Saltar: { $key }
hints-corner = En cada esquina se juntan cinco cuadrados, no cuatro, y hay una piedra de la que salen cinco caminos. Rodéala y cuéntalos. Recorridos: { $gone } · mapa grande: { $key }
hints-corner-back = Cinco cuadrados, y estás de vuelta. En terreno plano habrían sido cuatro.
hints-overhead = Mira arriba: la tierra sobre tu cabeza es el otro lado de este mundo.
hints-talk = Hablar con quien está delante: { $key }
hints-car = Subir a un coche, de cerca: { $key }
hints-map = La otra imagen de este espacio: { $key }
hints-camera = Verte por detrás, y volver: { $key }
hints-light = Está oscuro. Linterna: { $key }
hints-photo = Hacer fotos: { $key }
hints-home = Camina siempre recto, en cualquier dirección, hasta llegar a casa.
hints-dig = Cavar, sin soltar: { $key }
hints-build = Construir, sin soltar: { $key }
hints-make = Construyes con lo que cavas. Haz herramientas con ello: { $key } y después «Fabricar»
hints-curve = Cambiar la imagen del espacio: { $up } y { $down }
hints-backpack = Abrir la mochila: { $key }
hints-menu = Pausa, ajustes, todas las teclas: { $key }
hints-footer = { $step } de { $count } · omitir: { $key }
hints-footer-plain = { $step } de { $count }
hints-stick-left = palanca izquierda
hints-stick-right = palanca derecha

menu-skip-hints = Omitir los consejos
action-skip-hint = Omitir un consejo
setting-hints = Consejos para empezar
setting-hints-about = Dicen en el mundo, uno tras otro, qué se puede hacer. Tras el último se apagan solos; al encenderlos empiezan de nuevo.
