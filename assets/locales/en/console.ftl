### The console, and the mark of worlds in which a command that cheats was used.

action-console = Console

console-entry = Command
console-hint = A command; Tab completes it, help tells of all, Esc closes
console-no-command = There is no command “{ $name }”. help lists those there are.
console-refused = That cannot be done: { $details }.
console-settled = All land around you is there.
console-unsettled = { $count ->
    [one] One piece of land is still being made.
   *[other] { $count } pieces of land are still being made.
}
console-no-wait = Here time passes by itself; only scripts wait.
console-no-perf = Only scripts measure. While you play, the frame figures tell what a frame takes.
console-marked = This world is marked from now on: a command that cheats was used in it.
console-saving = The world is being saved.
console-not-kept = This world has no name, so it is not kept.
console-open-already = “{ $name }” is open already.
console-no-worlds = No world is saved yet.
console-world = { $name } ({ $space }, seed { $seed })
console-shot-name = The picture goes into { $dir }; give it a name without a folder.

cheats-used = Cheats used

# What a command does. The words after it stand on the line above.
console-help = Commands: { $commands }. help COMMAND tells more of one.
console-help-new = Makes a new world and enters it; the one you are in is saved first.
console-help-load = Enters a saved world; the one you are in is saved first.
console-help-save = Saves this world now.
console-help-delete = Deletes a saved world for ever.
console-help-list = Lists the saved worlds.
console-help-quit = Saves this world and ends the game.
console-help-hold = Holds a key or a button of the mouse for some seconds.
console-help-down = Presses a key and keeps it down until “up”.
console-help-up = Lets a key go.
console-help-tap = Presses a key and lets it go.
console-help-click = Presses a button of the mouse and lets it go.
console-help-press = Presses a button of the mouse and keeps it down until “release”.
console-help-release = Lets a button of the mouse go.
console-help-look = Turns the view as the mouse would, by pixels to the right and down.
console-help-aim = Points the view, in degrees: 0 is along x, 90 along z; up is positive.
console-help-scroll = Turns the wheel by notches.
console-help-wait = Lets time pass; in scripts only.
console-help-settle = Tells whether all land around you is there; a script waits for it.
console-help-probe = Tells the state of the world as one line of JSON.
console-help-shot = Keeps a picture of what you see, without the console, in the folder of screenshots.
console-help-set = Changes a setting of this world, or one of your own as the settings screen has them. time, health and fly on mark the world.
console-help-give = Gives you items. Marks the world.
console-help-teleport = Puts you somewhere else, in metres of the chart. Marks the world.
console-help-spawn = Puts a figure, a car, a lamp or a flag into the world.
console-help-name-flag = Gives the flag nearest to you a name.
console-help-perf = Measures frames; in scripts only.
console-help-help = Tells of all commands, or of one.
