### Hints for newcomers, shown one after another in the first world.

hints-look = Mira a tu alrededor: { $key }
hints-walk = Caminar: { $key }
hints-jump = Saltar: { $key }
hints-dig = Cavar, sin soltar: { $key }
hints-build = Construir, sin soltar: { $key }
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
