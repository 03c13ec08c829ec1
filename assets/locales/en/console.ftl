### The console, and the mark of worlds in which a command that cheats was used.

action-console = Console
action-workshop = Workshop: build or walk

console-entry = Command
console-hint = A command. Tab completes it, help lists all commands, Esc closes the console
console-no-command = There is no command “{ $name }”. help lists all commands.
console-refused = That cannot be done: { $details }.
console-settled = All land around you is loaded.
console-unsettled = { $count ->
    [one] One piece of land is still loading.
   *[other] { $count } pieces of land are still loading.
}
console-no-wait = Time passes by itself in the game. Only scripts can wait.
console-no-perf = Only scripts can measure. While you play, the frame figures show how long a frame takes.
console-marked = This world is now marked, because a command that cheats was used in it.
console-saving = The world is being saved.
console-not-kept = This world has no name, so it is not kept.
console-open-already = “{ $name }” is open already.
console-no-worlds = No world is saved yet.
console-room-changed = Changed. “room save” keeps it.
console-room-saved = The room is saved.
console-no-versions = There are no older versions of this room.
console-world = { $name } ({ $space }, seed { $seed })
console-shot-name = Pictures are saved in { $dir }. Give a name without a folder.

cheats-used = Cheats used

# What a command does. The words after it stand on the line above.
console-help = Commands: { $commands }. help COMMAND explains one of them.
console-help-new = Makes a new world and enters it; the one you are in is saved first.
console-help-load = Enters a saved world; the one you are in is saved first.
console-help-save = Saves this world now.
console-help-delete = Deletes a saved world permanently.
console-help-list = Lists the saved worlds.
console-help-quit = Saves this world and ends the game.
console-help-hold = Holds a key or a mouse button for a number of seconds.
console-help-down = Presses a key and keeps it down until “up”.
console-help-up = Lets a key go.
console-help-tap = Presses a key and lets it go.
console-help-click = Presses a mouse button and lets it go.
console-help-press = Presses a mouse button and keeps it down until “release”.
console-help-release = Lets a mouse button go.
console-help-look = Turns the view as the mouse would, by pixels to the right and down.
console-help-aim = Points the view, in degrees: 0 is along x, 90 along z; up is positive.
console-help-scroll = Turns the wheel by notches.
console-help-wait = Lets time pass; in scripts only.
console-help-settle = Says whether all land around you is loaded. A script waits until it is.
console-help-probe = Prints the state of the world as one line of JSON.
console-help-shot = Saves a picture of your view, without the console, in the folder for screenshots.
console-help-set = Changes a setting of this world, or one of the settings screen. “time”, “health” and “fly on” mark the world.
console-help-give = Gives you items, or in a gathering world cubic metres of a kind of ground. Marks the world.
console-help-make = Makes an item of ground that you have gathered.
console-help-teleport = Puts you somewhere else, in metres of the chart. Marks the world.
console-help-spawn = Puts a figure, a car, a lamp or a flag into the world.
console-help-name-flag = Names the flag nearest to you.
console-help-perf = Measures frames; in scripts only.
console-help-room = Makes, enters, keeps, deletes or lists rooms of deformed space, and goes back to older versions of one.
console-help-add = Puts something into the room that is open.
console-help-change = Changes something in the room that is open.
console-help-remove = Takes something out of the room that is open.
console-help-group = Makes a group in the room that is open, which carries its members.
console-help-carry = Lets a group carry things, or none.
console-help-ungroup = Takes groups away and leaves what they carried.
console-help-duplicate = Copies things in the room that is open.
console-help-array = Copies things in a row or in a ring.
console-help-undo = Takes back the last changes of the room that is open, or the last strokes of the brush in a world.
console-help-redo = Makes changes of the room again that were taken back.
console-help-help = Explains all commands, or one of them.
