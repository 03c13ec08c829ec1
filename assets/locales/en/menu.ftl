### The main menu, the form for a new world and the dialogs.

# The column of buttons.
menu-resume = Resume
menu-save = Save
menu-save-and-quit = Save and quit to menu
menu-begin-anew = Start over
menu-build-here = Build here
menu-leave-room = Leave the room
menu-new-game = New Game
menu-load = Load
menu-delete = Delete
menu-rooms = Rooms
menu-workshop = Workshop
menu-controls = Controls
menu-quit = Quit
version = Version { $version }
adapter-software = No graphics card was found, so the processor draws ({ $adapter }) at { $percent } % of the window's resolution. A smaller window or view distance makes it faster.
running-world = { $name } · seed { $seed }

back = Back
ok = OK
percent = { $percent } %

# The form for a new world.
name = Name
name-hint = What is the world called?
name-offered = World { $number }
name-free = This name is free.
name-not-shown = Some of its characters cannot be shown here, so the name of its folder is shown beside it.
space = Space
geometry-hyperbolic = Hyperbolic lens
geometry-hyperbolic-about = Flat, endless land in bent space. It drops away on all sides; the wheel changes how much.
geometry-hyperbolic-world = Hyperbolic world
geometry-hyperbolic-world-about = More room than flat land has: five squares meet at every corner, and a way back is not the way you think.
geometry-euclidean = Euclidean
geometry-euclidean-about = Flat space, endless and familiar.
geometry-spherical = Spherical
geometry-spherical-about = A closed world: the land climbs and meets overhead, and a walk right round it leads home.
mode = Mode
mode-creative = Creative
mode-creative-about = Every tool from the start; building costs nothing.
mode-gathering = Gathering
mode-gathering-about = You build with what you dig, and make tools from it.
seed = Seed (optional)
seed-hint = A number or words
seed-random = An empty seed is chosen at random.
seed-is = The seed is { $seed }.
seed-too-large = Too large: the largest seed is 18446744073709551615.
seed-not-whole = A number must be whole and not negative: digits only.
seed-too-long = Too long: at most 64 characters.
seed-unprintable = Only printable characters, please.
radius-metres = { $metres } m
radius = Size: the radius of the world
radius-moonlet = Moonlet
radius-moon = Moon
radius-planet = Planet
radius-named = { $name }, { $metres } m
radius-round = Around the world: { $metres } m, { $minutes } minutes at a walk.
squares = Size: how wide a square is, five about every corner
squares-wide = { $metres } m
squares-land = Within { $metres } m there is { $times } times as much land as on flat ground.
create = Create
needs-name = Needs a valid name
needs-seed = Needs a valid seed

# A world that could not be saved before leaving it.
unsaved-title = The world is not saved
unsaved-again = Try again
unsaved-stay = Stay in the world
unsaved-leave = Leave without saving

# What the player waits for.
busy-opening = Opening
busy-opening-about = The game reads the world from disk.
busy-opening-room = The game reads the room from disk and makes its picture ready.
busy-land = Making the land
busy-saving = Saving
busy-saving-about = The game writes your world to disk.
busy-leaving = Leaving
