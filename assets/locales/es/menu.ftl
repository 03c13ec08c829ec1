### El menú principal, el formulario de un mundo nuevo y los diálogos.

# La columna de botones.
menu-resume = Continuar
menu-save = Guardar
menu-save-and-quit = Guardar y salir al menú
menu-begin-anew = Empezar de nuevo
menu-build-here = Construir aquí
menu-leave-room = Salir de la sala
menu-new-game = Partida nueva
menu-load = Cargar
menu-delete = Borrar
menu-rooms = Salas
menu-workshop = Taller
menu-controls = Controles
menu-quit = Salir del juego
version = Versión { $version }
adapter-software = No se encontró tarjeta gráfica: dibuja el procesador ({ $adapter }), al { $percent } % de la resolución de la ventana. Ayuda una ventana o distancia pequeña.
running-world = { $name } · semilla { $seed }

back = Atrás
ok = Aceptar
percent = { $percent } %

# El formulario de un mundo nuevo.
name = Nombre
name-hint = ¿Cómo se llamará?
name-offered = Mundo { $number }
name-free = Este nombre está libre.
name-not-shown = Algunos de sus caracteres no se pueden mostrar aquí: a su lado estará el nombre de la carpeta.
space = Espacio
geometry-hyperbolic = Lente hiperbólica
geometry-hyperbolic-about = Tierra llana y sin fin, vista en un espacio curvo: cae por todos lados, tanto como gires la rueda.
geometry-hyperbolic-world = Mundo hiperbólico
geometry-hyperbolic-world-about = Más sitio que en la tierra llana: en cada esquina se juntan cinco cuadrados, y el camino de vuelta no es el que crees.
geometry-euclidean = Euclídeo
geometry-euclidean-about = Espacio plano, sin fin y familiar.
geometry-spherical = Esférico
geometry-spherical-about = Un mundo cerrado: la tierra sube y se junta sobre la cabeza, y quien le da la vuelta llega a casa.
mode = Modo
mode-creative = Creativo
mode-creative-about = Todas las herramientas desde el principio; construir no cuesta nada.
mode-gathering = Recolección
mode-gathering-about = Construyes con lo que sacas al cavar y haces herramientas con ello.
seed = Semilla (opcional)
seed-hint = Un número o palabras
seed-random = Si queda vacía, se elige al azar.
seed-is = La semilla es { $seed }.
seed-too-large = Demasiado grande: la mayor semilla es 18446744073709551615.
seed-not-whole = Un número debe ser entero y no negativo: solo cifras.
seed-too-long = Demasiado larga: 64 caracteres como máximo.
seed-unprintable = Solo caracteres visibles, por favor.
radius-metres = { $metres } m
radius = Tamaño: el radio del mundo
radius-moonlet = Lunita
radius-moon = Luna
radius-planet = Planeta
radius-named = { $name }, { $metres } m
radius-round = Una vuelta: { $metres } m, { $minutes } minutos a pie.
squares = Tamaño: el ancho de un cuadrado, cinco en cada esquina
squares-wide = { $metres } m
squares-land = A menos de { $metres } m hay { $times } veces más tierra que en suelo llano.
create = Crear
needs-name = Falta un nombre válido
needs-seed = Falta una semilla válida

# Un mundo que no se pudo guardar antes de dejarlo.
unsaved-title = El mundo no está guardado
unsaved-again = Reintentar
unsaved-stay = Seguir en el mundo
unsaved-leave = Salir sin guardar

# Lo que el jugador espera.
busy-opening = Abriendo
busy-opening-about = El mundo se lee del disco.
busy-opening-room = La sala se lee del disco y se prepara su imagen.
busy-land = Creando la tierra
busy-saving = Guardando
busy-saving-about = Tu mundo se escribe en el disco.
busy-leaving = Saliendo
