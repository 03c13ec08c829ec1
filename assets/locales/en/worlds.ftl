### The lists of worlds.

worlds-none = There are no worlds yet. New Game makes one.
worlds-load-named = Load “{ $name }”
worlds-delete-named = Delete “{ $name }”
worlds-manage = Manage “{ $name }”
worlds-running = Running now
worlds-running-no-delete = This world is running. Save and quit to the menu first, then delete it.
worlds-running-no-change = This world is running. Save and quit to the menu first, then change it.
worlds-cannot-load-title = “{ $name }” cannot be loaded
worlds-cannot-delete-title = “{ $name }” cannot be deleted now

# What is known of a world.
worlds-played = played { $time }
worlds-played-briefly = under a minute
worlds-played-minutes = { $minutes } min
worlds-played-hours = { $hours } h { $minutes } min
worlds-size = { $megabytes } MB
worlds-size-small = { $kilobytes } kB
worlds-edits = { $count ->
    [0] nothing changed yet
    [one] { $count } changed chunk
   *[other] { $count } changed chunks
}
worlds-edits-unknown = counting the changed chunks

# The page of one world.
worlds-load = Load
worlds-rename = Rename
worlds-duplicate = Duplicate
worlds-export = Export
worlds-open-folder = Open folder
worlds-delete = Delete
worlds-keep = Keep
worlds-cancel = Cancel
worlds-delete-question = Delete “{ $name }”?
worlds-delete-final = This cannot be undone.
worlds-rename-title = Rename “{ $name }”
worlds-new-name = New name
worlds-name-free = This name can be used.
worlds-export-title = Export “{ $name }”
worlds-file = File
worlds-export-hint = The whole world goes into this one file, to keep or to give away. Nothing is overwritten.

# Worlds from files.
worlds-import = Import
worlds-import-title = Import a world
worlds-import-do = Import
worlds-import-hint = The file of an exported world. You can also drop it on the window.
worlds-found = Exported worlds in { $dir }:
worlds-found-none = There are no exported worlds in { $dir }.
worlds-import-named = { $name } ({ $size })
worlds-folder-named = { $name } (folder)
worlds-folder-above = Folder above
worlds-folder-unread = { $dir } cannot be read ({ $reason }). Choose another folder, or type a path.
worlds-export-folders = The file goes to { $dir }. Another folder:

# Work on the saves, and what it came to.
worlds-work-delete = Deleting a world
worlds-work-rename = Renaming a world
worlds-work-duplicate = Copying a world
worlds-work-export = Exporting a world
worlds-work-import = Importing a world
worlds-renamed = The world is called “{ $name }” now.
worlds-duplicated = “{ $name }” is a copy of the world.
worlds-exported = The world was exported to { $file }.
worlds-imported = “{ $name }” was imported.
worlds-list-died = The list of worlds could not be read. The log has the details.
worlds-work-died = Something failed. The log has the details.
worlds-folder-failed = The folder { $dir } could not be opened: { $reason }. You can open it by hand.
worlds-folder-no-program = no program for showing folders was found
worlds-folder-refused = the system has no program to show it

# Rooms of deformed space, where they are told in other words than worlds.
rooms-none = There are no rooms yet.
rooms-new = New room
rooms-load-named = Enter “{ $name }”
rooms-running = You are in it now
rooms-running-no-change = You are in this room. Leave it first, then change it.
rooms-shipped = This room comes with the game. Duplicate it, and change the copy.
rooms-objects = { $count ->
    [one] { $count } object
   *[other] { $count } objects
}
rooms-load = Enter
rooms-export-hint = The whole room goes into this one file, to keep or to give away. Nothing is overwritten.
rooms-import-title = Import a room
rooms-import-hint = The file of an exported room. You can also drop it on the window.
rooms-found = Exported rooms in { $dir }:
rooms-found-none = There are no exported rooms in { $dir }.
rooms-work-delete = Deleting a room
rooms-work-rename = Renaming a room
rooms-work-duplicate = Copying a room
rooms-work-export = Exporting a room
rooms-work-import = Importing a room
rooms-renamed = The room is called “{ $name }” now.
rooms-duplicated = “{ $name }” is a copy of the room.
rooms-exported = The room was exported to { $file }.
rooms-imported = “{ $name }” was imported.
rooms-list-died = The list of rooms could not be read. The log has the details.
