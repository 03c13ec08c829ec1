### The settings screen. Keys made at run time: setting-<id>.

menu-settings = Settings
settings-search = Search the settings
settings-nothing-found = No setting matches “{ $words }”.
settings-reset = Reset
settings-reset-named = Reset “{ $name }”

settings-group-look = Mouse and view
settings-group-picture = Picture
settings-group-world = Space
settings-group-comfort = Language, reading and comfort

# { $value } is a number.
unit-degrees = { $value }°
unit-degrees-per-pixel = { $value }° a pixel
unit-chunks = { $value ->
    [0] Automatic
    [one] { $value } chunk
   *[other] { $value } chunks
}
unit-notch = { $value } a notch
unit-times = { $value } ×

setting-mouse-sensitivity = Mouse sensitivity
setting-mouse-sensitivity-about = How far the view turns when the mouse moves by one pixel.
setting-invert-look = Invert up and down
setting-invert-look-about = Moving the mouse away looks down, as in an aeroplane.
setting-field-of-view = Field of view
setting-field-of-view-about = The angle between the upper and the lower edge of the picture. Wide angles show more and make everything smaller.

setting-preset = Made for
setting-preset-about = With a graphics card land has grass, ripples, pebbles and layers near by, and is lit pixel by pixel. For a processor it has the colours of its biome alone, which is faster. Automatic goes by what draws.
setting-preset-auto = Automatic
setting-preset-card = A graphics card
setting-preset-software = A processor

setting-quality = Quality
setting-quality-about = How much accuracy the pictures give up for speed.
setting-quality-fast = Fast
setting-quality-balanced = Balanced
setting-quality-exact = Exact
setting-view-distance = View distance
setting-view-distance-about = How far the land around you reaches; a chunk is 32 metres. Automatic is more than 300 metres with a graphics card. A larger distance costs memory and time.
setting-render-scale = Resolution of the world
setting-render-scale-about = The resolution of the world, as a share of the window's. Text stays sharp. Automatic means 100 % with a graphics card and 50 % without one.
setting-render-scale-auto = Automatic
setting-render-scale-25 = 25 %
setting-render-scale-50 = 50 %
setting-render-scale-67 = 67 %
setting-render-scale-75 = 75 %
setting-render-scale-100 = 100 %
setting-msaa = Smooth edges (MSAA)
setting-msaa-about = Smooths the edges of land with several samples per pixel. Automatic means four samples with a graphics card and one without.
setting-msaa-auto = Automatic
setting-msaa-off = Off
setting-msaa-4x = 4 samples
setting-shadows = Shadows
setting-shadows-about = Shadows of the sun and the moon. High is finer and softer. Automatic means high with a graphics card and low without one.
setting-shadows-auto = Automatic
setting-shadows-off = Off
setting-shadows-low = Low
setting-shadows-high = High
setting-frame-cap = Frame limit
setting-frame-cap-about = The most pictures per second. Fewer pictures keep the machine cool and quiet.
setting-frame-cap-30 = 30
setting-frame-cap-60 = 60
setting-frame-cap-90 = 90
setting-frame-cap-120 = 120
setting-frame-cap-144 = 144
setting-frame-cap-240 = 240
setting-frame-cap-none = No limit
setting-vsync = Wait for the screen (VSync)
setting-vsync-about = Shows a new picture only between two refreshes of the screen. Without it pictures appear sooner but may tear.
setting-fullscreen = Fullscreen
setting-fullscreen-about = The game fills the screen.

setting-curvature-step = Step of the curvature
setting-curvature-step-about = How far one notch of the wheel turns the curvature's dial.
setting-hyperbolic-map = Hyperbolic map
setting-hyperbolic-map-about = The map of new hyperbolic worlds. A change here also changes the world you are in. Each world remembers its own map.
setting-hyperbolic-map-raised = Raised
setting-hyperbolic-map-horizon = Horizon
setting-contour-bands = Contour lines
setting-contour-bands-about = Faint lines on the land, one every 8 metres of height. They show how space bends.
setting-compass = Compass
setting-compass-about = Shows at the top of the screen where north and your flags are. In spherical worlds it also shows the hemisphere and the way to the equator, in hyperbolic worlds the way home.
setting-minimap = Map
setting-minimap-about = A round map of the land around you, with heights, lamps, flags and the figures nearby.
setting-rear-mirror = Rear mirror
setting-rear-mirror-about = A mirror at the top of the view from a car's bonnet. Automatic means on with a graphics card and off without one.
setting-rear-mirror-auto = Automatic
setting-rear-mirror-off = Off
setting-rear-mirror-on = On
setting-straight-shots = Straight shots
setting-straight-shots-about = Bullets follow the straightest lines of the space instead of falling in an arc.

setting-language = Language
setting-language-about = The language of all text. System means the language of your computer, if the game has it.
setting-language-system = System
setting-language-en = English
setting-language-pl = Polski
setting-language-de = Deutsch
setting-language-es = Español
setting-language-zh = 中文
setting-ui-scale = Size of text and buttons
setting-ui-scale-about = The size of the menus and the display.
setting-high-contrast = High contrast
setting-high-contrast-about = Menus and display are white and yellow on black, and nothing shines through.
setting-safe-marker = Ring for colour blindness
setting-safe-marker-about = The ring around the place where you dig or build is white with black edges. It differs by brightness and not by colour.
setting-reduced-motion = Less motion
setting-reduced-motion-about = The curvature jumps instead of gliding, menus do not fade, the head does not dip, the view from the bonnet does not lean, and no world flies by behind the menu.
setting-head-dip = Head dips on landing
setting-head-dip-about = The view sinks a little when you land from a jump or a fall.
setting-wind = Wind
setting-wind-about = Leaves and grass sway. Still with less motion.

# The file of the settings. { $file } is a path, { $reason } comes from the system, { $value } from the file.
settings-file-damaged = The settings file was damaged. The game uses the settings that it could read, and keeps the damaged file as { $file }.
settings-file-newer = The settings file comes from a newer version of the game. The game uses the settings that it knows, and keeps the file as { $file }.
settings-file-older = The settings file came from an older version and has been updated. The old file is kept as { $file }.
settings-file-kept = Some of the settings file could not be used. The original is kept as { $file }.
settings-file-value = The setting “{ $name }” has its default value, because the value { $value } in the file is not allowed.
settings-file-unknown = The settings file names “{ $name }”, which this version does not know.
settings-file-input = “{ $name }” is bound to { $value } in the settings file, which is no key, button or wheel.
settings-file-profile = The key profile “{ $name }” of the settings file is left out.
settings-file-unreadable = The settings file { $file } could not be read ({ $reason }). The game uses the defaults, and changes are not saved.
settings-file-stuck = The settings file { $file } could not be put aside ({ $reason }). It is left as it is, and changes are not saved.
settings-file-no-place = The system has no folder for settings, so changes are not saved. --config FILE chooses a file.
settings-file-unsaved = The settings could not be saved to { $file } ({ $reason }). They stay in effect until the game ends.
settings-file-more = { $count ->
    [one] One more thing in the settings file could not be used.
   *[other] { $count } more things in the settings file could not be used.
}
settings-not-applied = This setting could not be applied: { $reason }
