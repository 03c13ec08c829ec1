### The backpack over the running world.

action-backpack = Backpack

backpack-title = Backpack
# What a slot is called, and a thing with how many there are of it.
backpack-slot = Slot { $number }: { $item }
backpack-slot-empty = Slot { $number }: empty
backpack-item = { $item } × { $count }
backpack-throw = Throw away
backpack-close = Close
# The page on which things are made of ground, the way to it and back, what is carried of ground, and what a thing takes of a kind out of what is there.
backpack-make = Make things
backpack-slots = Slots
making-carried = You carry:
making-nothing = You carry no ground. Dig to gather some.
making-where = Coal lies in beds from 2 m below the ground on, copper in veins from 4 m, often under clay, and crystal from 7 m, under gravel, and in the halls of caves.
making-earth = { $kind } { $volume } m³
making-part = { $kind } { $has } of { $needs } m³
# What the button that makes a thing is called, with what it takes.
making-recipe = Make { $item }: { $parts }
# What the mouse does, and what the keys do, in a few lines.
backpack-how = Left button: take, put down, drag · Right: take half, put one · Shift + left: to the other part · Outside: throw away
backpack-how-keys = Arrows: move · Enter: take, put down · Ctrl + Enter: take half, put one · Shift + Enter: to the other part · Number: swap with the hotbar

# What a thing does, in a sentence.
item-gun-about = Shoots a bullet at what the crosshair covers.
item-bullet-about = What the gun shoots.
item-lamp-about = Lights up the land around it. Can be put down and picked up again.
item-flag-about = Marks a place. Plant it, click on it to name it, take it up again: map and compass show the way to it.
item-door-about = One of a pair. Put up two: what goes into one comes out of the other. Take one up again with the right button.
item-log-about = A piece of a trunk. Put it up as a post, or make things of its wood.
item-stone-about = Put it down to build with, or make things of its rock.
item-seed-about = Plant it in soft ground: it becomes a tree of that land and grows from day to day.
item-crumb-about = Lay them along your way: hold the button and walk. Map and compass show the way back along them.
item-pickaxe-wood-about = Digs and builds, slowly. Where ground is gathered, it leaves copper and crystal.
item-pickaxe-iron-about = Digs and builds three times as fast as wood. Where ground is gathered, it digs copper, too.
item-pickaxe-diamond-about = Digs and builds five times as fast as wood. Where ground is gathered, it digs crystal, too.
