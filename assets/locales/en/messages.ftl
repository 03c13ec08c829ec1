### Toasts, hints and what can go wrong. { $path } is a file or a folder, { $details } are English sentences.

saved = Saved

# Answers to keys.
hint-map-raised = The raised map
hint-map-horizon = The horizon map
hint-no-other-map = The sphere has no other map.
hint-bent = { $up } bends the picture to hyperbolic, { $down } to spherical.
hint-unbent = The picture is flat again.
hint-no-bullets = You have no bullets left.
hint-no-place-for-lamp = A lamp needs ground to stand on, within eight metres.
hint-none-there-lamp = There is no lamp under the crosshair.
hint-too-many-lamp = There are too many lamps in this world; pick one up first.
room-hint-no-place-for-lamp = A lamp needs something to stand on under the crosshair, within eight metres.
room-hint-too-many-lamps = This room has eight lamps of its own, and no more can shine.
room-hint-nothing-to-lift = There is nothing loose under the crosshair within three metres.
room-hint-too-heavy = That is too heavy to lift; push it.
room-hint-fell-out = You fell out of the room, and begin anew.
room-hint-for-worlds = { $key } is for worlds. In a room the gun, lamps and balls are at hand all the time.
hint-no-place-for-flag = A flag needs ground that is not too steep, within eight metres.
hint-none-there-flag = There is no flag under the crosshair.
hint-too-many-flag = There are too many flags in this world; take one up first.
hint-no-place-for-log = A log needs free ground to stand on, within eight metres.
hint-no-place-for-stone = A stone needs free ground to lie on, within eight metres.
hint-no-place-for-seed = A seed needs soft, level ground under open air, a step away from other trees, within eight metres.
hint-no-place-for-crumb = A breadcrumb needs ground within eight metres.
hint-none-there-crumb = There is no breadcrumb under the crosshair.
hint-last-crumb = That was your last breadcrumb: your trail ends here.
hint-too-many-crumb = There are too many breadcrumbs in this world; take one up first.
hint-moved-crumb = You took up the first breadcrumb and laid it here: a world has 512 of them at most.
hint-none-there-log = There is no log under the crosshair.
hint-none-there-stone = There is no stone under the crosshair.
hint-too-many-log = There are too many logs in this world; take one up first.
hint-too-many-stone = There are too many stones in this world; take one up first.
hint-too-many-seed = No more trees can be planted here.
hint-no-place-for-door = There is no ground within eight metres for the door to stand on.
hint-door-steep = The ground here is too steep for a door: find a level place, or dig or build one.
hint-door-walled = Rock is in the way here: a door needs a metre of room before and behind it.
hint-door-crowded = The other door is too close: leave two and a half metres between them.
against-door-steep = too steep for a door
against-door-walled = rock in the way
against-door-crowded = too close to the other door
hint-none-there-door = There is no door under the crosshair.
hint-too-many-door = This world has its pair of doors already; take one up first.
hint-moved-door = The older door stands here now.
hint-no-room = You cannot carry any more.
hint-too-many-drops = Too many things lie around already; pick something up first.
hint-died-of-fall = You fell too far. You will stand up again where you began.
hint-died-of-shot = You were shot. You will stand up again where you began.
hint-died-of-crash = The crash killed you. You will stand up again where you began.
hint-died-of-car = A car ran you over. You will stand up again where you began.
hint-died-of-tree = A tree fell on you. You will stand up again where you began.
hint-no-car-near = There is no car in view within four metres.
hint-look-at-car = The car is beside you. Look at it to get in.
hint-car-too-far = The car is too far away to get in. Go closer.
hint-at-the-wheel = At the wheel. Brake: { $brake } · Camera: { $camera } · Horn: { $horn } · Get out: { $leave }
hint-fallen-over = The car has fallen over. { $flip } sets it on its wheels.
hint-no-way-out = There is no free ground beside the car to get out on.
hint-back-again = You are back at the start. What you carried is still with you.
hint-been-round = You have come all the way round the world, { $metres } m, and are back where you were.
hint-nobody-to-talk-to = There is nobody ahead to talk to.
hint-too-far-to-talk = They are too far away to talk to. Go closer.
hint-waits-to-talk = They have heard you and wait. Go closer to talk.
hint-in-the-way = You stand in the way of what you build, under a roof. Step back, or take a smaller brush.
hint-out-of-reach = Nothing to dig is within reach. Go closer.
hint-too-hard = Too hard for this pickaxe: { $kind }. A better one can be made of what you dig.
hint-nothing-to-build = You have no ground to build with. Dig some first.
hint-used-up = None left to build with: { $kind }. Choose another kind, or dig more.
hint-made = Made: { $item }
hint-no-coal-yet = You have dug deep and found no coal. Its beds lie under about half of the land: dig some thirty metres on, or look at the walls of a cave.
hint-undone = The last stroke is undone.
hint-undo-none-left = There is no stroke left to undo.
hint-undo-away = The last stroke is too far away to be undone. Go back to where you made it.
hint-undo-changed = The last stroke stays: its ground has been changed since.
hint-undo-spent = The last stroke stays: the ground that it brought has been used since.
hint-undo-unreadable = The last stroke stays: what is stored of its ground cannot be read now. See that the disk is there and try again.

# What others say about their space. { $side }, { $away }, { $there } and { $round } are metres, { $sum } and { $angle } degrees.
talk-triangle-flat = I put up three lamps, each { $side } m from the other two. Seen from one another they make { $sum }° together, as at school.
talk-triangle-pictured = I put up three lamps, each { $side } m from the other two. Seen from one another they make { $sum }° together: the land is flat, and only its picture is bent.
talk-hello = Hello! { $words }
talk-triangle-more = I put up three lamps, each { $side } m from the other two. Seen from one another they make { $sum }° together, more than 180.
talk-triangle-less = I put up three lamps, each { $side } m from the other two. Seen from one another they make { $sum }° together, less than 180.
talk-horizon-lower = See the ground { $away } m off, as high as this? It looks { $angle }° lower than it would in a flat picture.
talk-horizon-flat = See the ground { $away } m off, as high as this? It is just where a flat picture shows it.
talk-horizon-higher = See the ground { $away } m off, as high as this? It looks { $angle }° higher than it would in a flat picture.
talk-home-round = Home is { $there } m from here, or { $round } m the other way, right round the world.
talk-home-straight = Home is { $there } m from here. This land has no end, so there is no way round.
talk-home-squares = Home is { $there } m from here, { $squares ->
    [0] in this square
    [one] { $squares } square away
   *[other] { $squares } squares away
}. Every other way there is longer, and most are much longer.
talk-land = At this height there is { $times } times as much land within { $within } m as on flat ground. Lower down there is more.
talk-square = Walk { $side } m, turn right, and do that four times. On flat ground you would be back; here you end { $gap } m from where you began.

# Titles of what went wrong, and what is said where nothing more is known.
open-failed = The world could not be opened
open-died = Something failed while the game read the world. The log has the details.
save-failed = The world could not be saved
close-died = Something failed while the game wrote the world. The log has the details.
not-saved = The last changes to the world are not saved.
not-saved-yet = The world could not be saved; the next save tries again.
save-unfinished = The last change to the terrain or its save did not finish in time; everything saved before is safe.

# Saves.
save-in-use = The world “{ $world }” is in use: it is open in another window of the game or another program. Close it there and try again.
save-newer = The world “{ $world }” was saved by a newer version of the game. Update the game to play it; nothing has been changed.
save-damaged = A part of this world is damaged. The rest can be used; “antipode saves repair” restores an older copy of it if there is one. ({ $details })
save-part-damaged = A part of this world is damaged. The rest can be used; “antipode saves verify” says which, and “antipode saves repair” restores an older copy of it if there is one.
save-unreadable = The save { $path } is damaged and cannot be read. “antipode saves repair” salvages what is whole and keeps this file.
save-file-missing = The file { $path } of this world is missing. If you have a copy of it, put it back; otherwise “antipode saves repair” makes the world anew where it can.
save-vanished = The save { $path } is gone: its folder was moved, deleted or replaced while the world was open, so nothing can be saved there. Move the folder back and save again.
save-not-found = There is no world “{ $world }” any more.
saves-busy = Another game is making, renaming or importing a world in { $path } and has not finished. Try again in a moment, or close the other game.
saves-not-a-folder = { $path } is a file, so there can be no worlds in it. Choose a folder with --saves-dir.
file-exists = { $path } exists already and is not overwritten. Choose another name or move it away.
disk-full = There is no space left to write { $path }. Free some space and save again; what was saved before is safe.
not-writable = { $path } cannot be written: it is read-only or belongs to someone else. Change its permissions, or choose another place with --saves-dir.
not-readable = { $path } cannot be read: its permissions forbid it, or it belongs to someone else. Change its permissions, or choose another place with --saves-dir.
archive-refused = { $path } cannot be imported: it is not an exported world, or it is damaged. The log has the details.
unknown-space = The world “{ $world }” is in a space this version does not know. A newer version of the game may open it.
unknown-generator = The land of “{ $world }” is made in a way this version does not know. A newer version of the game may open it.
impossible-radius = The world “{ $world }” says that its space has a radius of { $radius } m, and no world can have that. Its file was left as it is.
player-damaged = The player in this save was damaged, so you begin at the start again. Your land is unchanged.
unknown-item = The save holds an item this version does not know (“{ $item }”); it is not shown, but stays in the save.
unknown-records = { $count ->
    [one] The save holds a thing of a newer version; it is not shown, but stays in the save.
   *[other] The save holds { $count } things of a newer version; they are not shown, but stay in the save.
}
unknown-map = The save names a map this version does not know (“{ $map }”); another is shown.
more-damaged = { $count ->
    [one] One more place in this world is damaged; “antipode saves verify” lists it.
   *[other] { $count } more places in this world are damaged; “antipode saves verify” lists them.
}
land-trouble = Something is wrong with the land. { $details }
other-trouble = That did not work. { $details }

# Names of worlds.
name-empty = Give the world a name.
name-blank = The name needs at least one character that can be seen.
name-too-long = { $chars ->
    [one] The name has one character; at most { $most } fit.
   *[other] The name has { $chars } characters; at most { $most } fit.
}
name-unprintable = The name contains a character that cannot be shown ({ $code }).
name-taken = A world called “{ $name }” exists already.
room-name-taken = There is a room called “{ $name }” already.

# The graphics adapter.
no-adapter = No graphics card that the game can use was found on this machine ({ $found }). Install its driver, or start the game with --adapter software.
adapter-lost = The graphics adapter was lost. Your world is safe; start the game again.
adapter-refuses = The graphics adapter refuses a shader of the game ({ $details }). Update its driver, or start the game with --adapter software.
adapter-reopened = The graphics adapter was lost and has been opened again.

# Why the game was started anew after its graphics had failed for good, and what draws now.
graphics-title = The graphics have failed
graphics-lost = The graphics adapter was lost and could not be opened again. Your world is saved.
graphics-software = The game has restarted and the processor draws now, which is slower. To try the graphics card again, quit and start the game once more.

# A crash of the game before this one.
crash-title = The game has crashed
crash = The game stopped unexpectedly and has restarted. Your worlds and rooms are as they were last saved, a few seconds earlier at most. The file { $report } says what is known about the crash.

# Biomes: the name alone is shown to whoever enters one.
biome-volcanic = Volcanic land
biome-desert = Desert
biome-forest = Forest
biome-toxic = Toxic flats
biome-jungle = Jungle
biome-tundra = Tundra
biome-wetland = Wetland
biome-crags = Crags
biome-shore = Shore
biome-cave = Cave
