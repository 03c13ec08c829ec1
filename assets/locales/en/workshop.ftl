### The workshop, in which rooms are built.

# Rooms to build in.
workshop-rooms-none = You have no rooms of your own yet. Make a new one, or duplicate one of the game on its page (the three dots). The first one comes with a lesson.
workshop-rooms-shipped = Rooms of the game
workshop-rooms-load = Build
workshop-rooms-load-named = Build in “{ $name }”
workshop-not-own = This room comes with the game. Duplicate it, and build in the copy.
workshop-not-kept = The room could not be kept: { $reason }
workshop-not-saved-yet = Your edits are kept, but the file of the room is as it was before until this is mended: { $reason }
workshop-kept = The room is being saved. It saves itself, too: each step within two seconds.

# Panes.
workshop-pane-view = View
workshop-pane-list = Objects
workshop-pane-inspector = Inspector
workshop-pane-parts = Parts
workshop-pane-messages = Messages
workshop-pane-history = History
workshop-search = Search
workshop-none-found = Nothing is called so.
workshop-rename = New name
workshop-hide = Hide “{ $name }”
workshop-fold = Fold “{ $name }”
workshop-lock = Lock “{ $name }”
workshop-reset = Reset { $name }
workshop-parts-hint = A click puts a part on what you look at.
workshop-all-well = Nothing is wrong with this room.
workshop-note-ahead = The last edits of this room had not reached its file when the game ended. They are back, and nothing is to be done.
workshop-note-changed = Something else has changed the file of this room since it was last kept here. That is the last step of the history; take it back to have the room as it was.
workshop-note-aside = The journal of this room was damaged and is put aside as { $file }. Older steps may be missing; “Older versions” in the history shows what else is kept.
workshop-in-use = This room is being built in by another window of the game. Here you can walk through it; close it there first to build here.
workshop-no-journal = The folder of this room cannot be written ({ $reason }). You can walk through it; to build here, make its folder writable and enter it again.
workshop-drop-elsewhere = Files can be dropped into a room while you build in it: Workshop in the main menu, or F5 in a room of your own.
workshop-drop-choose = Choose first what the picture is to lie on, then bring it again.
workshop-older = Older versions
workshop-older-about = A click puts that version in place of the room. That is a step, and can be taken back.
workshop-older-none = There are no older versions yet. One is kept half a minute after an edit.
workshop-beginning = The beginning
workshop-room-itself = The room itself
workshop-one = { $name } ({ $kind })
workshop-several = { $count ->
    [one] { $count } object
   *[other] { $count } objects
}
workshop-status-nothing = Click something, or fly: hold the right button, and W A S D, E, Q.
workshop-status-chosen = Drag it or a handle · arrow keys: one step · F: look at it · Alt: no steps
workshop-status-turn = Drag a ring: steps of 15° · F: look at it · Alt: no steps
workshop-status-scale = Drag a handle: the other side stays · F: look at it · Alt: no steps
workshop-status-scale-whole = Drag a handle: all of it grows · F: look at it
workshop-status-flies = W A S D, E and Q fly, arrow keys turn. V or Esc ends it.
workshop-status-late = Drawing anew …
workshop-outside-inside = { $outside } m outside, { $inside } m inside

# What is done.
workshop-do-play = Play
workshop-do-leave = Leave the room
workshop-do-undo = Undo
workshop-do-redo = Redo
workshop-do-move = Move
workshop-do-turn = Turn
workshop-do-scale = Scale
workshop-do-own-axes = Own axes
workshop-do-snaps = Snap
workshop-do-on-surfaces = On surfaces
workshop-do-copy = Copy
workshop-do-cut = Cut
workshop-do-paste = Paste
workshop-do-duplicate = Duplicate
workshop-do-array = Repeat in a row
workshop-do-group = Group
workshop-do-ungroup = Ungroup
workshop-do-delete = Delete
workshop-do-choose-all = Select all
workshop-do-focus = Look at the selection
workshop-do-top = From above
workshop-do-front = From the front
workshop-do-side = From the side
workshop-do-start = From the start
workshop-do-flies = Fly by keys
workshop-do-raster = Fast picture first
workshop-grid = { $metres } m
workshop-menu-edit = Edit
workshop-menu-room = Room
workshop-menu-view = View
workshop-key-ctrl = Ctrl
workshop-key-shift = Shift

# Units.
workshop-unit-metres = { $value } m
workshop-unit-degrees = { $value }°
workshop-unit-times = × { $value }
workshop-unit-plain = { $value }

# Kinds of things.
workshop-kind-box = box
workshop-kind-pyramid = pyramid
workshop-kind-ramp = ramp
workshop-kind-cylinder = cylinder
workshop-kind-ball = ball
workshop-kind-stairs = stairs
workshop-kind-arch = arch
workshop-kind-model = model
workshop-kind-light = lamp
workshop-kind-aberration = space
workshop-kind-portal = portal
workshop-kind-sign = sign
workshop-kind-group = group

# Parts.
workshop-part-box = Box
workshop-about-box = A block of one metre.
workshop-part-wall = Wall
workshop-about-wall = 4 m wide, 2.5 m high.
workshop-part-floor = Floor
workshop-about-floor = A slab of 4 by 4 m.
workshop-part-pyramid = Pyramid
workshop-about-pyramid = Its tip is up.
workshop-part-ramp = Ramp
workshop-about-ramp = It rises to its front.
workshop-part-stairs = Stairs
workshop-about-stairs = Eight steps up 2 m.
workshop-part-arch = Arch
workshop-about-arch = A block with a gate through it.
workshop-part-cylinder = Cylinder
workshop-about-cylinder = Upright, 2 m high.
workshop-part-ball = Ball
workshop-about-ball = A ball of one metre.
workshop-part-light = Lamp
workshop-about-light = Light from one point; a room has eight at most.
workshop-part-sign = Sign
workshop-about-sign = A board to read.
workshop-part-tunnel = Tunnel
workshop-about-tunnel = 4 m outside, 20 m inside, with walls of its own. Nothing is bent in it.
workshop-part-hall = Larger space
workshop-about-hall = An open box, twice as large inside. Who enters is half as large. Put walls round it, or take the house.
workshop-part-portals = Pair of portals
workshop-about-portals = Who goes into one comes out of the other.

# Fields.
workshop-field-name = Name
workshop-field-at = Place
workshop-field-at-group = Place in the group
workshop-field-turn = Turn (about y, z, x)
workshop-field-size = Size
workshop-field-radius = Radius
workshop-field-height = Height
workshop-field-steps = Steps
workshop-field-opening = Gate
workshop-field-scale = Scale
workshop-field-text = Text
workshop-field-colour = Colour
workshop-field-power = Brightness
workshop-field-checker = Chequered
workshop-field-checker-colour = Second colour
workshop-field-checker-size = Side of a square
workshop-field-texture-file = Picture
workshop-texture-none = A picture may lie on it: Ctrl+O.
workshop-field-texture-size = Side of the picture
workshop-field-finish = Finish
workshop-field-glow = Glow
workshop-field-box = Size outside
workshop-field-lengths = What it stretches
workshop-field-axis = Axis
workshop-field-felt = Length inside
workshop-field-times = Stretch
workshop-field-times-x = Stretch along x
workshop-field-times-y = Stretch along y
workshop-field-times-z = Stretch along z
workshop-field-thesis = The thesis's d
workshop-field-sides = Sides
workshop-field-ways = Works for
workshop-field-outline = Edges are seen
workshop-field-to = Leads to
workshop-field-sentence = What is strange here
workshop-field-spawn-at = Start
workshop-field-spawn-look = Look at the start (yaw, pitch)
workshop-field-gravity = Gravity
workshop-field-sky = Sky
workshop-field-light = Ambient light
workshop-field-has-sun = Sun
workshop-field-sun = Where it stands
workshop-field-sun-colour = Colour of the sun
workshop-field-sun-power = Brightness of the sun
workshop-field-has-fog = Fog
workshop-field-fog = Nothing is seen from
workshop-field-fog-colour = Colour of the fog
workshop-choice-finish-matt = Matt
workshop-choice-finish-mirror = Mirror
workshop-choice-finish-glass = Glass
workshop-choice-lengths-felt = One axis
workshop-choice-lengths-stretch = All axes
workshop-choice-axis-x = x (red)
workshop-choice-axis-y = y (green)
workshop-choice-axis-z = z (blue)
workshop-choice-sides-walls = Walls
workshop-choice-sides-soft = Open
workshop-choice-sides-snell = Refracting
workshop-choice-sides-legacy = The thesis's rule
workshop-choice-sides-1 = One side
workshop-choice-sides-2 = Both sides
workshop-choice-ways-both = Everybody who enters
workshop-choice-ways-forward = Only who goes along the axis

# What space does.
workshop-told-felt = It is { $outside } m long outside and feels { $inside } m long inside: { $seconds } s at a walk, in place of { $before }.
workshop-told-smaller = Who enters is { $times } times smaller, so everything in it is as many times larger. The view is not bent by that.
workshop-told-larger = Who enters is { $times } times larger, so everything in it is as many times smaller. The view is not bent by that.
workshop-told-walls = It has walls of its own; nothing is bent, and its doors are as large inside as outside.
workshop-told-soft = Directions stay the same through every face: one walks to what one sees.
workshop-told-snell = Light is refracted as in glass, and beyond an angle reflected.
workshop-told-legacy = The thesis's rule has faults: what is seen depends on where one looks, and one does not walk to it.
workshop-told-no-door = Walls leave no door where more than one axis is stretched. Stretch one axis, or make the sides open.
workshop-told-astigmatic = Straight lines look bent through it, since its sides are stretched unequally.
workshop-told-grazing = Along its sides things look squeezed.
workshop-told-itself = It leads to itself: it shows who looks in.
workshop-told-alike = It is as large as “{ $name }”: who passes keeps their size.
workshop-told-grows = Who goes to “{ $name }” becomes { $times } times as large.
workshop-told-shrinks = Who goes to “{ $name }” becomes { $times } times smaller.

# Steps of the history.
workshop-step-add = { $count ->
    [one] Add “{ $name }”
   *[other] Add { $count } objects
}
workshop-step-remove = { $count ->
    [one] Delete “{ $name }”
   *[other] Delete { $count } objects
}
workshop-step-move = { $count ->
    [one] Move “{ $name }”
   *[other] Move { $count } objects
}
workshop-step-turn = { $count ->
    [one] Turn “{ $name }”
   *[other] Turn { $count } objects
}
workshop-step-pose = { $count ->
    [one] Place “{ $name }”
   *[other] Place { $count } objects
}
workshop-step-resize = { $count ->
    [one] Size “{ $name }”
   *[other] Size { $count } objects
}
workshop-step-stretch = { $count ->
    [one] Stretch “{ $name }”
   *[other] Stretch { $count } objects
}
workshop-step-sides = { $count ->
    [one] Sides of “{ $name }”
   *[other] Sides of { $count } objects
}
workshop-step-surface = { $count ->
    [one] Surface of “{ $name }”
   *[other] Surface of { $count } objects
}
workshop-step-link = { $count ->
    [one] Link “{ $name }”
   *[other] Link { $count } portals
}
workshop-step-text = { $count ->
    [one] Text of “{ $name }”
   *[other] Text of { $count } signs
}
workshop-step-light = { $count ->
    [one] Light of “{ $name }”
   *[other] Light of { $count } lamps
}
workshop-step-change = { $count ->
    [one] Change “{ $name }”
   *[other] Change { $count } objects
}
workshop-step-rename = Rename “{ $name }” to “{ $new }”
workshop-step-group = Group “{ $name }”
workshop-step-carry = { $count ->
    [one] Take “{ $name }” out of its group
   *[other] Take { $count } objects out of groups
}
workshop-step-ungroup = { $count ->
    [one] Ungroup “{ $name }”
   *[other] Ungroup { $count } groups
}
workshop-step-duplicate = { $count ->
    [one] Duplicate “{ $name }”
   *[other] Duplicate { $count } objects
}
workshop-step-array = { $count ->
    [one] Repeat “{ $name }”
   *[other] Repeat { $count } objects
}
workshop-step-paste = { $count ->
    [one] Paste “{ $name }”
   *[other] Paste { $count } objects
}
workshop-step-room = The room itself
workshop-step-spawn = The start
workshop-step-several = Several changes
workshop-step-outside = Changed outside of the game
workshop-step-version = Version { $when }

# What may be wrong.
workshop-finding-not-parallel = “{ $name }” lies partly in “{ $other }” and is turned another way; it is closed until their axes are parallel, or one lies wholly in the other.
workshop-finding-too-deep = “{ $name }” lies in too many stretched spaces in one another, “{ $other }” among them; eight is the most.
workshop-finding-walls-across = A wall of “{ $name }” stands across “{ $other }”, so one cannot walk through there; move one of them away.
workshop-finding-same-place = “{ $name }” is in the same place as “{ $other }”; move it, or take it away.
workshop-finding-tangled = “{ $name }” lies in so many others that it cannot be told how deep; move some apart.
workshop-finding-no-door = “{ $name }” has walls on all six sides, and nobody could enter.
workshop-finding-out-of-range = “{ $name }” has a number that is out of range.
workshop-finding-no-partner = The portal “{ $name }” leads nowhere: there is no portal of the name that it leads to.
workshop-finding-one-way = The portal “{ $name }” leads to “{ $other }”, which does not lead back.
workshop-finding-other-sides = “{ $name }” and “{ $other }” do not have as many sides.
workshop-finding-not-similar = “{ $name }” does not feel similar to its partner “{ $other }”: give them sizes in proportion.
workshop-finding-other-size = “{ $name }” differs in size from its partner “{ $other }” by more than 32 times.
workshop-finding-portal-shape = The corners of “{ $name }” are no convex shape.
workshop-finding-over-side = The portal “{ $name }” lies over a side of “{ $other }”; put it wholly in or out.
workshop-finding-in-odd-box = The portal “{ $name }” stands in “{ $other }”, in which portals cannot stand.
workshop-finding-portals-touch = The portals “{ $name }” and “{ $other }” touch; move them apart by a millimetre at least.
workshop-finding-spawn-in-solid = The start is inside of “{ $name }”.
workshop-finding-spawn-in-air = { $metres ->
    [0] One begins over nothing, and falls out of the room.
    [one] One begins in the air and falls { $metres } m.
   *[other] One begins in the air and falls { $metres } m.
}
workshop-finding-open-sides = The sides of “{ $name }” are open: light is bent there. Cover them, or give it walls.
workshop-finding-fall-out = One can fall out of the room, after { $metres } m of walking.
workshop-finding-unreached = “{ $name }” cannot be reached on foot from where one begins.

# Help, and parts of several things.
workshop-reset-short = reset
workshop-menu-help = Help
workshop-do-lesson = Take the lesson
workshop-do-examples = What is possible
workshop-do-parallel = Without perspective
workshop-do-walls = Hide walls of tunnels
workshop-field-times-all = Stretch of all axes
workshop-field-group = In the group
workshop-choice-group-none = None
workshop-part-house = House larger inside
workshop-about-house = A house of 4 m with a door. Inside it is twice as large, and who enters half as large.

# The lesson.
workshop-lesson-title = Lesson, step { $number } of { $of }
workshop-lesson-put = Click “House larger inside” among the parts: it stands before you then.
workshop-lesson-move = Drag the house a little aside with the left button.
workshop-lesson-choose = Click “{ $name }” in the list of objects: that is the space in the house.
workshop-lesson-stretch = Pull the slider “Stretch of all axes” to the right: the house gets larger inside and stays as it is outside.
workshop-lesson-enter = Press Play (F5) and walk in through the door.
workshop-lesson-walk = Walk in through the door of the house. F5 leads back to the workshop.
workshop-lesson-walk-tunnel = Walk through the tunnel, and count your steps. F5 leads back to the workshop.
workshop-lesson-done = You have built a house that is larger inside. Back in the workshop (F5), Help has a second lesson, of tunnels and portals, and shows what else is possible.
workshop-lesson-skip = Skip this step
workshop-lesson-end = End the lesson

# What is possible.
workshop-examples-title = What is possible
workshop-examples-about = Each of these can be copied into your room and changed there.
workshop-examples-copy = Copy into the room
workshop-examples-copy-named = Copy “{ $name }” into the room
workshop-examples-close = Close
workshop-example-tunnel-longer = Tunnel longer inside
workshop-example-tunnel-longer-about = 4 m beside it, 20 m through it.
workshop-example-tunnel-shorter = Tunnel shorter inside
workshop-example-tunnel-shorter-about = 16 m beside it, 2 m through it.
workshop-example-house = House larger inside
workshop-example-house-about = Four metres outside, eight inside.
workshop-example-portals = Pair of portals
workshop-example-portals-about = Who goes into the one comes out of the other.
workshop-example-portals-of-size = Portals of different size
workshop-example-portals-of-size-about = Who comes out of the large one is three times as large.
workshop-example-falling-loop = A fall without end
workshop-example-falling-loop-about = What falls in below comes out above.

# Partners of portals.
workshop-link-to = Drag it onto another portal.
workshop-link-partner = Leads to “{ $name }”: drag to another
workshop-told-no-partner = It leads nowhere and is closed: choose the portal that it leads to.
workshop-told-one-way = It is closed: “{ $name }” does not lead back.
workshop-told-other-sides = It is closed: “{ $name }” has another number of sides.
workshop-told-not-similar = It is closed: “{ $name }” has another shape. Give both the same proportion of width to height.
workshop-told-ill-placed = It is closed: it or “{ $name }” stands where none may stand. The messages say why.

# Files from the disk.
workshop-do-from-file = Model or picture from a file
workshop-do-keep = Save now
workshop-chooser-title = A model or a picture
workshop-chooser-about = A model (glb, gltf, fbx, obj) stands before you then; a picture (png, jpg) lies on what is selected.
workshop-chooser-path = Path
workshop-chooser-open = Open
workshop-chooser-up = Folder above
workshop-chooser-home = My folder
workshop-chooser-close = Cancel
workshop-chooser-reading = The folder is being read.
workshop-chooser-empty = There is no folder, model or picture here.
workshop-chooser-folder = folder
workshop-chooser-unread = { $path } cannot be read ({ $reason }). Type another path, or go on from the folder below.
workshop-chooser-unfit = { $path } is no model (glb, gltf, fbx, obj) and no picture (png, jpg). Save it as one of these, or choose another file.
workshop-chooser-many = The first { $shown } of { $count } are shown; type the path of another.

# What fields do, where the pointer rests.
workshop-hover-sides = What is at the faces through which nobody is meant to walk: walls, nothing, or something like glass.
workshop-hover-ways = Who comes from the other end may find the space as long as it looks.
workshop-hover-outline = The edges of the box are drawn in the game, too, not only here.
workshop-hover-lengths = One axis makes a tunnel longer or shorter; all axes make a room larger or smaller inside.
workshop-hover-thesis = How a thesis, the first program of such rooms, counts stretch, the other way round: a metre inside takes up 1 + d metres outside. 0 changes nothing, 2 is a third as long inside, −0.8 five times as long.

# The second lesson, and a portal alone.
workshop-do-lesson-doors = Lesson: tunnel and portals
workshop-part-portal = Portal
workshop-about-portal = It leads to itself until a line is dragged from it to another.
workshop-lesson-tunnel = Click “Tunnel” among the parts: it stands before you then.
workshop-lesson-longer = With “{ $name }” selected pull the slider “Stretch” to the right: it gets longer inside and stays as it is outside.
workshop-lesson-portal = Click “Portal” among the parts: it is the first of two.
workshop-lesson-portal-again = Click “Portal” once more: the second stands beside the first.
workshop-lesson-link = Drag from the knob above “{ $name }” to the middle of “{ $other }”: they lead to each other then.
workshop-lesson-through = Press Play (F5) and walk through the tunnel.
workshop-lesson-pass = Press Play (F5) and walk into one portal: you come out of the other.
workshop-lesson-walk-doors = That was the tunnel. Now walk into a portal. F5 leads back to the workshop.
workshop-lesson-done-doors = You have built a tunnel that is longer inside, and two portals that lead to each other. Help in the workshop (F5) shows what else is possible.
workshop-link-itself = Leads to itself: drag to another portal
workshop-link-nowhere = Leads nowhere: drag to a portal
workshop-hover-own-axes = Handles go by the thing's own axes, not by those of the room.
workshop-hover-snaps = Moves go by steps of the grid, turns by 15°. Alt lets go of that for a drag.
workshop-hover-on-surfaces = What is dragged lies on the surface under the pointer: floors, walls, roofs.

# What parts and their things are called in a room.
workshop-name-bottom = bottom
workshop-name-top = top
workshop-name-falling-loop = falling loop
workshop-name-falling-loop-lintel = falling loop lintel
workshop-name-falling-loop-pillar = falling loop pillar
workshop-name-falling-loop-rim = falling loop rim
workshop-name-house = house
workshop-name-house-back = house back
workshop-name-house-ceiling = house ceiling
workshop-name-house-floor = house floor
workshop-name-house-front = house front
workshop-name-house-inside = house inside
workshop-name-house-lamp = house lamp
workshop-name-house-left = house left
workshop-name-house-light = house light
workshop-name-house-lining-back = house lining back
workshop-name-house-lining-front = house lining front
workshop-name-house-lining-left = house lining left
workshop-name-house-lining-right = house lining right
workshop-name-house-right = house right
workshop-name-house-roof = house roof
workshop-name-large-portal = large portal
workshop-name-large-portal-frame = large portal frame
workshop-name-left-post = left post
workshop-name-lintel = lintel
workshop-name-long-tunnel = long tunnel
workshop-name-long-tunnel-inside = long tunnel inside
workshop-name-long-tunnel-slab = long tunnel slab
workshop-name-portal = portal
workshop-name-portal-frame = portal frame
workshop-name-right-post = right post
workshop-name-short-tunnel = short tunnel
workshop-name-short-tunnel-inside = short tunnel inside
workshop-name-short-tunnel-slab = short tunnel slab
workshop-name-small-portal = small portal
workshop-name-small-portal-frame = small portal frame
workshop-name-tunnel = tunnel
workshop-name-hall = hall
workshop-name-box = box
workshop-name-wall = wall
workshop-name-floor = floor
workshop-name-stairs = stairs
workshop-name-ramp = ramp
workshop-name-arch = arch
workshop-name-pyramid = pyramid
workshop-name-cylinder = cylinder
workshop-name-ball = ball
workshop-name-light = light
workshop-name-sign = sign
workshop-name-group = group
workshop-name-model = model
workshop-told-carried = All that it carries is { $x } m wide, { $y } m high and { $z } m deep.

# The form of how something is repeated in a row.
workshop-array-count = How many
workshop-array-axis = Along
workshop-array-gap = Free between
workshop-array-turn = Turned, each
workshop-array-make = Make them
workshop-array-close = Close
workshop-misread = “{ $text }” is no number: it stays as it was.
