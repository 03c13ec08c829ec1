### La consola, y la marca de los mundos en los que se usó una orden tramposa.

action-console = Consola
action-workshop = Taller: construir o andar

console-entry = Orden
console-hint = Una orden; Tab la completa, help las enumera, Esc cierra
console-no-command = No hay ninguna orden «{ $name }». help enumera las que hay.
console-refused = No se puede hacer: { $details }.
console-settled = Todo el terreno a tu alrededor está listo.
console-unsettled = { $count ->
    [one] Aún se está creando un trozo de terreno.
   *[other] Aún se están creando { $count } trozos de terreno.
}
console-no-wait = Aquí el tiempo pasa solo; únicamente los guiones esperan.
console-no-perf = Solo los guiones miden. Mientras juegas, los datos de imagen dicen cuánto tarda cada una.
console-marked = Este mundo queda marcado: se ha usado en él una orden tramposa.
console-saving = El mundo se está guardando.
console-not-kept = Este mundo no tiene nombre, así que no se conserva.
console-open-already = «{ $name }» ya está abierto.
console-no-worlds = Todavía no hay mundos guardados.
console-room-changed = Cambiado. «room save» lo guarda.
console-room-saved = La sala está guardada.
console-no-versions = No hay versiones anteriores de esta sala.
console-world = { $name } ({ $space }, semilla { $seed })
console-shot-name = La imagen va a { $dir }; dale un nombre sin carpeta.

cheats-used = Con trampas

console-help = Órdenes: { $commands }. help ORDEN dice más de una.
console-help-new = Crea un mundo nuevo y entra en él; antes se guarda el actual.
console-help-load = Entra en un mundo guardado; antes se guarda el actual.
console-help-save = Guarda este mundo ahora.
console-help-delete = Borra para siempre un mundo guardado.
console-help-list = Enumera los mundos guardados.
console-help-quit = Guarda este mundo y termina el juego.
console-help-hold = Mantiene una tecla o un botón del ratón unos segundos.
console-help-down = Pulsa una tecla y la mantiene hasta «up».
console-help-up = Suelta una tecla.
console-help-tap = Pulsa una tecla y la suelta.
console-help-click = Pulsa un botón del ratón y lo suelta.
console-help-press = Pulsa un botón del ratón y lo mantiene hasta «release».
console-help-release = Suelta un botón del ratón.
console-help-look = Gira la vista como el ratón, en píxeles hacia la derecha y hacia abajo.
console-help-aim = Apunta la vista, en grados: 0 a lo largo de x, 90 a lo largo de z; hacia arriba es positivo.
console-help-scroll = Gira la rueda por muescas.
console-help-wait = Deja pasar el tiempo; solo en guiones.
console-help-settle = Dice si todo el terreno a tu alrededor está listo; un guion lo espera.
console-help-probe = Da el estado del mundo como una línea de JSON.
console-help-shot = Guarda una imagen de lo que ves, sin la consola, en la carpeta de capturas.
console-help-set = Cambia un ajuste de este mundo o uno de los tuyos, como en la pantalla de ajustes. time, health y fly on marcan el mundo.
console-help-give = Te da objetos o, en un mundo de recolección, metros cúbicos de un tipo de suelo. Marca el mundo.
console-help-make = Fabrica un objeto con suelo que has recogido.
console-help-teleport = Te lleva a otro lugar, en metros de la carta. Marca el mundo.
console-help-spawn = Pone una figura, un coche, una lámpara o una bandera en el mundo.
console-help-name-flag = Da un nombre a la bandera más cercana.
console-help-perf = Mide imágenes; solo en guiones.
console-help-room = Crea, abre, guarda, borra o enumera salas de espacio deformado, y vuelve a versiones anteriores.
console-help-add = Pone algo en la sala abierta.
console-help-change = Cambia algo en la sala abierta.
console-help-remove = Quita algo de la sala abierta.
console-help-group = Crea en la sala abierta un grupo que lleva a sus miembros.
console-help-carry = Hace que un grupo lleve cosas, o ninguno.
console-help-ungroup = Quita grupos y deja lo que llevaban.
console-help-duplicate = Copia cosas en la sala abierta.
console-help-array = Copia cosas en fila o en círculo.
console-help-undo = Deshace los últimos cambios de la sala abierta, o los últimos trazos del pincel en un mundo.
console-help-redo = Rehace los cambios deshechos de la sala.
console-help-help = Habla de todas las órdenes, o de una.
