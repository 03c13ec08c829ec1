### Sound and gamepads. Keys made at run time: setting-<id>, key-<id>.

settings-group-sound = Sound
settings-group-pad = Gamepad
unit-percent = { $value } %
unit-degrees-per-second = { $value }° a second

setting-volume-master = Volume
setting-volume-master-about = The volume of all sounds together.
setting-volume-effects = Steps and tools
setting-volume-effects-about = How loud steps, landings, digging and building are.
setting-volume-ambience = Wind, day and night
setting-volume-ambience-about = How loud the wind is, and birds by day and crickets at night.
setting-volume-music = Music
setting-volume-music-about = How loud the music is; it is quiet and has long rests.
setting-volume-interface = Menus and hotbar
setting-volume-interface-about = How loud the ticks of menus and of the hotbar are.
setting-mute-elsewhere = Silent in the background
setting-mute-elsewhere-about = The game is silent while another window has the keyboard.
setting-pad-look-speed = Turning with the stick
setting-pad-look-speed-about = How fast the view turns with the right stick all the way over.
setting-pad-invert-look = Invert up and down of the stick
setting-pad-invert-look-about = Moving the right stick away looks down, as in an aeroplane.
setting-pad-dead-zone = Dead zone of the sticks
setting-pad-dead-zone-about = How far a stick may be from its middle and still count as released. A higher value helps if the view drifts by itself.

sound-none = There is no sound device, so the game is silent. It uses a device as soon as you plug one in.
sound-lost = The sound device is gone. The game is silent until there is one again.
sound-left-out = This game was built without sound.

pad-connected = Gamepad connected: { $name }
pad-disconnected = Gamepad disconnected: { $name }

key-pad-south = Pad A, lower
key-pad-east = Pad B, right
key-pad-west = Pad X, left
key-pad-north = Pad Y, upper
key-pad-left-bumper = Pad left bumper
key-pad-right-bumper = Pad right bumper
key-pad-left-trigger = Pad left trigger
key-pad-right-trigger = Pad right trigger
key-pad-select = Pad Select
key-pad-start = Pad Start
key-pad-left-stick = Pad left stick pressed
key-pad-right-stick = Pad right stick pressed
key-pad-up = Pad cross up
key-pad-down = Pad cross down
key-pad-left = Pad cross left
key-pad-right = Pad cross right
