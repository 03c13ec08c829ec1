### The settings screen. Keys made at run time: setting-<id>.

menu-settings = Ajustes
settings-search = Buscar en los ajustes
settings-nothing-found = Ningún ajuste habla de «{ $words }».
settings-reset = Restablecer
settings-reset-named = Restablecer «{ $name }»

settings-group-look = Ratón y vista
settings-group-picture = Imagen
settings-group-world = Espacio
settings-group-comfort = Idioma, lectura y comodidad

# { $value } is a number.
unit-degrees = { $value }°
unit-degrees-per-pixel = { $value }° por píxel
unit-chunks = { $value ->
    [0] Automática
    [one] { $value } trozo
   *[other] { $value } trozos
}
unit-notch = { $value } por paso
unit-times = { $value } ×

setting-mouse-sensitivity = Sensibilidad del ratón
setting-mouse-sensitivity-about = Cuánto gira la vista cuando el ratón se mueve un píxel.
setting-invert-look = Invertir arriba y abajo
setting-invert-look-about = Alejar el ratón baja la vista, como en un avión.
setting-field-of-view = Campo de visión
setting-field-of-view-about = El ángulo entre el borde superior y el inferior de la imagen. Uno ancho muestra más y lo hace todo más pequeño.

setting-preset = Imagen para
setting-preset-about = Con tarjeta gráfica el terreno tiene de cerca hierba, ondas, guijarros y capas, y se ilumina punto por punto. Para el procesador tiene solo los colores de su bioma, que es más rápido. Automática: según lo que dibuje.
setting-preset-auto = Automática
setting-preset-card = Tarjeta gráfica
setting-preset-software = Procesador

setting-quality = Calidad
setting-quality-about = Cuánta exactitud cambia la imagen por velocidad.
setting-quality-fast = Rápida
setting-quality-balanced = Equilibrada
setting-quality-exact = Exacta
setting-view-distance = Distancia de visión
setting-view-distance-about = Hasta dónde se hace terreno a tu alrededor; un trozo mide 32 metros. En automático son más de 300 metros con tarjeta gráfica. Cada paso más cuesta memoria y tiempo.
setting-render-scale = Resolución del mundo
setting-render-scale-about = La parte de la resolución de la ventana en que se dibuja el mundo. Los textos siguen nítidos. Automática: toda con tarjeta gráfica, la mitad sin ella.
setting-render-scale-auto = Automática
setting-render-scale-25 = 25 %
setting-render-scale-50 = 50 %
setting-render-scale-67 = 67 %
setting-render-scale-75 = 75 %
setting-render-scale-100 = 100 %
setting-msaa = Bordes suaves (MSAA)
setting-msaa-about = Toma varias muestras de un píxel donde acaba el terreno, para que los bordes no tengan escalones. Automático: cuatro con tarjeta gráfica, una sin ella.
setting-msaa-auto = Automático
setting-msaa-off = No
setting-msaa-4x = 4 muestras
setting-shadows = Sombras
setting-shadows-about = Las sombras del sol y de la luna. Con Alta son más finas y suaves. Automático: alta con tarjeta gráfica, baja sin ella.
setting-shadows-auto = Automático
setting-shadows-off = No
setting-shadows-low = Baja
setting-shadows-high = Alta
setting-frame-cap = Límite de imágenes
setting-frame-cap-about = Máximo de imágenes por segundo. Con menos, el equipo sigue fresco y callado.
setting-frame-cap-30 = 30
setting-frame-cap-60 = 60
setting-frame-cap-90 = 90
setting-frame-cap-120 = 120
setting-frame-cap-144 = 144
setting-frame-cap-240 = 240
setting-frame-cap-none = Sin límite
setting-vsync = Esperar a la pantalla (VSync)
setting-vsync-about = La imagen cambia solo entre dos refrescos de la pantalla. Sin esto llega antes y puede verse cortada.
setting-fullscreen = Pantalla completa
setting-fullscreen-about = El juego llena la pantalla.

setting-curvature-step = Paso de la curvatura
setting-curvature-step-about = Cuánto mueve la curvatura un paso de la rueda.
setting-hyperbolic-map = Mapa hiperbólico
setting-hyperbolic-map-about = El mapa con que empiezan los mundos hiperbólicos nuevos; si lo cambias aquí, cambia también en el mundo en que estás. Cada mundo recuerda el suyo.
setting-hyperbolic-map-raised = Elevado
setting-hyperbolic-map-horizon = Horizonte
setting-contour-bands = Curvas de nivel
setting-contour-bands-about = Líneas tenues sobre el terreno, una cada 8 metros de altura. Muestran cómo se dobla el espacio.
setting-compass = Brújula
setting-compass-about = Muestra arriba dónde está el norte; en los mundos esféricos, también el hemisferio y el camino al ecuador; en los mundos hiperbólicos, el camino a casa; y dónde están tus banderas.
setting-minimap = Minimapa
setting-minimap-about = Un mapa redondo del terreno a tu alrededor: alturas, lámparas, banderas y quién está cerca.
setting-rear-mirror = Espejo retrovisor
setting-rear-mirror-about = Un espejo arriba en la vista desde el capó del coche. Automático: con tarjeta gráfica, y no donde dibuja el procesador.
setting-rear-mirror-auto = Automático
setting-rear-mirror-off = No
setting-rear-mirror-on = Sí
setting-straight-shots = Disparos rectos
setting-straight-shots-about = Las balas siguen las líneas más rectas del espacio en vez de caer en arco.

setting-language = Idioma
setting-language-about = El idioma de todos los textos. Sistema es el de tu equipo, si el juego lo habla.
setting-language-system = Sistema
setting-language-en = English
setting-language-pl = Polski
setting-language-de = Deutsch
setting-language-es = Español
setting-language-zh = 中文
setting-ui-scale = Tamaño de textos y botones
setting-ui-scale-about = Lo grandes que se dibujan los menús y los indicadores.
setting-high-contrast = Contraste alto
setting-high-contrast-about = Menús e indicadores en blanco y amarillo sobre negro, sin transparencias.
setting-safe-marker = Anillo para daltónicos
setting-safe-marker-about = El anillo en torno a lo que cavas o construyes es blanco con bordes negros: lo dice la claridad y no el color.
setting-reduced-motion = Menos movimiento
setting-reduced-motion-about = La curvatura salta en vez de deslizarse, los menús no se desvanecen, la cabeza no se hunde, la vista desde el capó no se inclina y ningún mundo pasa tras el menú.
setting-head-dip = Hundirse al caer
setting-head-dip-about = La vista baja un poco cuando caes de un salto o de lo alto.
setting-wind = Viento
setting-wind-about = Las hojas y la hierba se mecen. Con menos movimiento quedan quietas.

# The file of the settings. { $file } is a path, { $reason } comes from the system, { $value } from the file.
settings-file-damaged = El archivo de ajustes estaba dañado. Vale lo que se pudo leer; el archivo dañado se guarda como { $file }.
settings-file-newer = El archivo de ajustes es de una versión más nueva del juego. Vale lo que se conoce de él; se guarda como { $file }.
settings-file-older = El archivo de ajustes era de una versión anterior y se ha puesto al día; el viejo se guarda como { $file }.
settings-file-kept = Parte del archivo de ajustes no se pudo usar; tal como estaba, se guarda como { $file }.
settings-file-value = El ajuste «{ $name }» tiene su valor inicial: el archivo dice { $value }, que no admite.
settings-file-unknown = El archivo de ajustes nombra «{ $name }», que esta versión no conoce.
settings-file-input = «{ $name }» está en el archivo de ajustes en { $value }, que no es tecla, botón ni rueda.
settings-file-profile = Se omite el perfil de teclas «{ $name }» del archivo de ajustes.
settings-file-unreadable = No se pudo leer el archivo de ajustes { $file } ({ $reason }). Valen los valores iniciales y los cambios no se guardan.
settings-file-stuck = No se pudo apartar el archivo de ajustes { $file } ({ $reason }). Queda como está y los cambios no se guardan.
settings-file-no-place = El sistema no da un lugar para los ajustes, así que los cambios no se guardan. --config FILE da uno.
settings-file-unsaved = No se pudieron guardar los ajustes en { $file } ({ $reason }). Valen hasta el final del juego.
settings-file-more = { $count ->
    [one] Una cosa más del archivo de ajustes no se pudo usar.
   *[other] { $count } cosas más del archivo de ajustes no se pudieron usar.
}
settings-not-applied = No se pudo aplicar este ajuste: { $reason }
