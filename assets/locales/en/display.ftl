### The display over the world.

# Two kinds of coordinates; names of their lines, in a word.
display-chart = chart
display-curved = curved
display-flat = flat space: the same
display-loading = Loading land: { $percent } %
display-hemisphere = Hemisphere { $letter }
display-brush = Brush { $radius } m
display-speed = { $speed } km/h

# The compass: letters of the quarters of the horizon, and the way to the equator: the hemisphere, how far it is.
# Or home: how far it is, and how many squares away.
compass-north = N
compass-east = E
compass-south = S
compass-west = W
compass-equator = { $letter } · equator { $metres } m
compass-home = Home { $metres } m · { $squares ->
    [0] this square
    [one] { $squares } square
   *[other] { $squares } squares
}
compass-flag = { $name } · { $metres } m
compass-way-back = Way back
display-sighting = Three flags: { $here }° + { $seen }° + { $third }° = { $sum }° · sides { $a }, { $b }, { $c } m

# What the dial under the wheel turns; a few words.
dial-raised = Curvature, raised
dial-horizon = Curvature, horizon
dial-bend-hyperbolic = Bend, hyperbolic
dial-bend-spherical = Bend, spherical
dial-bend-flat = Bend, flat

# The kind of space, among other words.
space-hyperbolic = hyperbolic lens
space-hyperbolic-world = hyperbolic world
space-euclidean = euclidean
space-spherical = spherical

# What is in hand.
item-pickaxe-wood = Wooden pickaxe
item-pickaxe-iron = Iron pickaxe
item-pickaxe-diamond = Diamond pickaxe
item-gun = Gun
item-bullet = Bullet
item-lamp = Lamp
item-flag = Flag
item-door = Door
item-log = Log
item-stone = Stone
item-seed = Seed
item-crumb = Breadcrumb
flag-unnamed = Flag { $number }
flag-name-title = What is this flag called?
flag-name = Name of the flag
flag-name-keep = Keep it as it is

# The frame figures: a block of short lines, each a name in a word and its figures.
figures-fps = { $frames } fps
figures-fps-unknown = fps n/a
figures-ms = { $ms } ms
figures-unknown = n/a
figures-times = { $fps }   frame { $frame }   gpu { $gpu }   { $time }
# Between space, map and quality.
figures-comma = { ", " }
figures-chunks = chunks
figures-chunks-are = { $frame } by frame, { $vertex } by vertex, { $refined } refined
figures-detail = detail
figures-detail-is = { $full } full, { $half } half, { $quarter } quarter, { $eighth } eighth
figures-drawn = drawn
figures-drawn-are = { $triangles } triangles
figures-saved = saved
figures-saved-are = { $outside } outside, { $hidden } hidden, { $small } too small
figures-error = error
figures-error-is = at most { $most } px, far land { $far } px
figures-dropped = dropped
figures-dropped-is = { $seconds } s of time
picture-raised = raised map { $value }
picture-horizon = horizon map { $value }
picture-bend = bend { $sign }{ $value }
quality-fast = fast
quality-balanced = balanced
quality-exact = exact

# In rooms: how far off what is under the crosshair is, and how large one is.
room-ahead = { $felt } m
room-ahead-bent = { $felt } m on foot, { $scene } m from outside
room-smaller = You are { $times } times smaller here than outside
room-larger = You are { $times } times larger here than outside
room-smaller-level = Along the floor you are { $times } times smaller here than outside
room-larger-level = Along the floor you are { $times } times larger here than outside
room-smaller-up = In height you are { $times } times smaller here than outside
room-larger-up = In height you are { $times } times larger here than outside
room-smaller-began = You are { $times } times smaller than at the start
room-larger-began = You are { $times } times larger than at the start
room-keys = { $look }: the exact view or that of the thesis · { $camera }: from behind · { $gun }: shoot · { $lamp }: put a lamp down or take it up · { $lift }: lift what is loose or set it down · { $ball }: throw a ball · { $anew }: begin anew · { $again }: this again · { $edges }: edges of the boxes
room-keys-own = { $build }: build here
# The ways to look at a room, and what differs in the middle of the picture.
room-look-split = Left by the rule of the thesis, the first try at such rooms; right exactly
room-look-thesis = By the rule of the thesis, the first try at such rooms
room-look-plain = As on the plan: nothing is stretched or bent
room-half-thesis = thesis
room-half-exact = exact
room-differs = In the middle: { $exact }, and by the thesis { $thesis }.
room-differs-bent = In the middle: { $exact }, and by the thesis { $thesis }, where light arrives bent by { $bent }°.
room-sky = the sky
room-own = This room is yours.
display-brush-shape = { $shape } { $radius } m
display-heap = { $sign }{ $volume } m³ { $kind }
display-ground-left = { $kind }, { $volume } m³ left
ground-none = Nothing yet
ground-found = As found
ground-grass = Grass
ground-soil = Soil
ground-sand = Sand
ground-gravel = Gravel
ground-rock = Rock
ground-ash = Ash
ground-snow = Snow
ground-moss = Moss
ground-clay = Clay
ground-basalt = Basalt
ground-slate = Slate
ground-coal = Coal
ground-copper = Copper
ground-crystal = Crystal
ground-wood = Wood
brush-ball = Ball
brush-box = Box
brush-cylinder = Cylinder
brush-flatten = Flatten
brush-smooth = Smooth
