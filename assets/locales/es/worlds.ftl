### The lists of worlds.

worlds-none = Todavía no hay mundos. Partida nueva crea uno.
worlds-load-named = Cargar «{ $name }»
worlds-delete-named = Eliminar «{ $name }»
worlds-manage = Gestionar «{ $name }»
worlds-running = En marcha
worlds-running-no-delete = Este mundo está en marcha. Primero guárdalo y sal al menú, después elimínalo.
worlds-running-no-change = Este mundo está en marcha. Primero guárdalo y sal al menú, después cámbialo.
worlds-cannot-load-title = No se puede cargar «{ $name }»
worlds-cannot-delete-title = Ahora no se puede eliminar «{ $name }»

# What is known of a world.
worlds-played = jugado { $time }
worlds-played-briefly = menos de un minuto
worlds-played-minutes = { $minutes } min
worlds-played-hours = { $hours } h { $minutes } min
worlds-size = { $megabytes } MB
worlds-size-small = { $kilobytes } kB
worlds-edits = { $count ->
    [0] nada cambiado todavía
    [one] { $count } bloque cambiado
   *[other] { $count } bloques cambiados
}
worlds-edits-unknown = contando los bloques cambiados

# The page of one world.
worlds-load = Cargar
worlds-rename = Renombrar
worlds-duplicate = Duplicar
worlds-export = Exportar
worlds-open-folder = Abrir carpeta
worlds-delete = Eliminar
worlds-keep = Conservar
worlds-cancel = Cancelar
worlds-delete-question = ¿Eliminar «{ $name }»?
worlds-delete-final = Esto no se puede deshacer.
worlds-rename-title = Renombrar «{ $name }»
worlds-new-name = Nombre nuevo
worlds-name-free = Este nombre se puede usar.
worlds-export-title = Exportar «{ $name }»
worlds-file = Archivo
worlds-export-hint = El mundo entero va a este único archivo, para guardarlo o regalarlo. No se sobrescribe nada.

# Worlds from files.
worlds-import = Importar
worlds-import-title = Importar un mundo
worlds-import-do = Importar
worlds-import-hint = El archivo de un mundo exportado. También se puede soltar sobre la ventana.
worlds-found = Mundos exportados en { $dir }:
worlds-found-none = No hay mundos exportados en { $dir }.
worlds-import-named = { $name } ({ $size })
worlds-folder-named = { $name } (carpeta)
worlds-folder-above = Carpeta superior
worlds-folder-unread = No se puede leer { $dir } ({ $reason }). Elige otra carpeta o escribe una ruta.
worlds-export-folders = El archivo va a { $dir }. Otra carpeta:

# Work on the saves, and what it came to.
worlds-work-delete = Eliminando un mundo
worlds-work-rename = Renombrando un mundo
worlds-work-duplicate = Copiando un mundo
worlds-work-export = Exportando un mundo
worlds-work-import = Importando un mundo
worlds-renamed = El mundo se llama ahora «{ $name }».
worlds-duplicated = «{ $name }» es una copia del mundo.
worlds-exported = El mundo está escrito en { $file }.
worlds-imported = «{ $name }» está importado.
worlds-list-died = No se pudo leer la lista de mundos; el registro dice el resto.
worlds-work-died = Algo falló al hacerlo; el registro dice el resto.
worlds-folder-failed = No se pudo abrir la carpeta { $dir }: { $reason }. Puedes abrirla a mano.
worlds-folder-no-program = no se encontró ningún programa que muestre carpetas
worlds-folder-refused = el sistema no encontró con qué mostrarla

# Rooms of deformed space, where they are told in other words than worlds.
rooms-none = Todavía no hay salas.
rooms-new = Sala nueva
rooms-load-named = Entrar en «{ $name }»
rooms-running = Estás en ella
rooms-running-no-change = Estás en esta sala. Primero sal de ella, después cámbiala.
rooms-shipped = Esta sala viene con el juego. Duplícala y cambia la copia.
rooms-objects = { $count ->
    [one] { $count } objeto
   *[other] { $count } objetos
}
rooms-load = Entrar
rooms-export-hint = La sala entera va a este único archivo, para guardarla o regalarla. No se sobrescribe nada.
rooms-import-title = Importar una sala
rooms-import-hint = El archivo de una sala exportada. También se puede soltar sobre la ventana.
rooms-found = Salas exportadas en { $dir }:
rooms-found-none = No hay salas exportadas en { $dir }.
rooms-work-delete = Eliminando una sala
rooms-work-rename = Renombrando una sala
rooms-work-duplicate = Copiando una sala
rooms-work-export = Exportando una sala
rooms-work-import = Importando una sala
rooms-renamed = La sala se llama ahora «{ $name }».
rooms-duplicated = «{ $name }» es una copia de la sala.
rooms-exported = La sala está escrita en { $file }.
rooms-imported = «{ $name }» está importada.
rooms-list-died = No se pudo leer la lista de salas; el registro dice el resto.
