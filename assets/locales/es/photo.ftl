### Capturas de pantalla y el modo foto.

action-screenshot = Captura de pantalla
action-photo-mode = Modo foto

picture-kept = Imagen guardada como { $file }
picture-disk-full = No queda espacio para escribir la imagen { $path }. Libera espacio e inténtalo de nuevo.
picture-read-only = No se puede escribir la imagen { $path }: el lugar es de solo lectura o pertenece a otra persona.
picture-not-kept = No se pudo guardar la imagen { $path }: { $reason }
picture-not-taken = No se pudo tomar la imagen: { $reason }

photo-title = Modo foto
photo-field-of-view = Campo de visión
photo-time = Hora del día
photo-curvature = Curvatura
photo-bend = Flexión
photo-figures = Ocultar figuras
photo-thirds = Cuadrícula de tercios
photo-size = Tamaño
photo-size-times = { $times } × ({ $width } × { $height })
photo-save = Guardar la imagen
photo-leave = Salir
photo-fly = { $keys } vuelan, un botón del ratón mantenido gira la vista, las flechas recorren esta lista
photo-saving = Guardando: { $percent } %
photo-left = se salió del modo foto antes de terminarla
photo-dial = { $value }
