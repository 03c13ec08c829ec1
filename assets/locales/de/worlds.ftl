### The lists of worlds.

worlds-none = Es gibt noch keine Welten. Neues Spiel erschafft eine.
worlds-load-named = „{ $name }“ laden
worlds-delete-named = „{ $name }“ löschen
worlds-manage = „{ $name }“ verwalten
worlds-running = Läuft gerade
worlds-running-no-delete = Diese Welt läuft gerade. Erst speichern und zum Menü zurückkehren, dann löschen.
worlds-running-no-change = Diese Welt läuft gerade. Erst speichern und zum Menü zurückkehren, dann ändern.
worlds-cannot-load-title = „{ $name }“ kann nicht geladen werden
worlds-cannot-delete-title = „{ $name }“ kann jetzt nicht gelöscht werden

# What is known of a world.
worlds-played = { $time } gespielt
worlds-played-briefly = unter einer Minute
worlds-played-minutes = { $minutes } min
worlds-played-hours = { $hours } h { $minutes } min
worlds-size = { $megabytes } MB
worlds-size-small = { $kilobytes } kB
worlds-edits = { $count ->
    [0] noch nichts geändert
    [one] { $count } geänderter Block
   *[other] { $count } geänderte Blöcke
}
worlds-edits-unknown = die geänderten Blöcke werden gezählt

# The page of one world.
worlds-load = Laden
worlds-rename = Umbenennen
worlds-duplicate = Duplizieren
worlds-export = Exportieren
worlds-open-folder = Ordner öffnen
worlds-delete = Löschen
worlds-keep = Behalten
worlds-cancel = Abbrechen
worlds-delete-question = „{ $name }“ löschen?
worlds-delete-final = Das lässt sich nicht rückgängig machen.
worlds-rename-title = „{ $name }“ umbenennen
worlds-new-name = Neuer Name
worlds-name-free = Dieser Name ist möglich.
worlds-export-title = „{ $name }“ exportieren
worlds-file = Datei
worlds-export-hint = Die ganze Welt kommt in diese eine Datei, zum Aufheben oder Weitergeben. Nichts wird überschrieben.

# Worlds from files.
worlds-import = Importieren
worlds-import-title = Eine Welt importieren
worlds-import-do = Importieren
worlds-import-hint = Die Datei einer exportierten Welt. Man kann sie auch auf das Fenster ziehen.
worlds-found = Exportierte Welten in { $dir }:
worlds-found-none = In { $dir } sind keine exportierten Welten.
worlds-import-named = { $name } ({ $size })
worlds-folder-named = { $name } (Ordner)
worlds-folder-above = Ordner darüber
worlds-folder-unread = { $dir } lässt sich nicht lesen ({ $reason }). Wähle einen anderen Ordner, oder tippe einen Pfad.
worlds-export-folders = Die Datei kommt nach { $dir }. Ein anderer Ordner:

# Work on the saves, and what it came to.
worlds-work-delete = Eine Welt wird gelöscht
worlds-work-rename = Eine Welt wird umbenannt
worlds-work-duplicate = Eine Welt wird kopiert
worlds-work-export = Eine Welt wird exportiert
worlds-work-import = Eine Welt wird importiert
worlds-renamed = Die Welt heißt jetzt „{ $name }“.
worlds-duplicated = „{ $name }“ ist eine Kopie der Welt.
worlds-exported = Die Welt steht in { $file }.
worlds-imported = „{ $name }“ ist importiert.
worlds-list-died = Die Liste der Welten konnte nicht gelesen werden; Näheres steht im Protokoll.
worlds-work-died = Dabei ist etwas fehlgeschlagen; Näheres steht im Protokoll.
worlds-folder-failed = Der Ordner { $dir } konnte nicht geöffnet werden: { $reason }. Er lässt sich von Hand öffnen.
worlds-folder-no-program = es fand sich kein Programm, das Ordner zeigt
worlds-folder-refused = das System fand nichts, das ihn zeigt

# Rooms of deformed space, where they are told in other words than worlds.
rooms-none = Es gibt noch keine Räume.
rooms-new = Neuer Raum
rooms-load-named = „{ $name }“ betreten
rooms-running = Hier bist du gerade
rooms-running-no-change = Du bist gerade in diesem Raum. Erst verlassen, dann ändern.
rooms-shipped = Dieser Raum gehört zum Spiel. Dupliziere ihn und ändere die Kopie.
rooms-objects = { $count ->
    [one] { $count } Gegenstand
   *[other] { $count } Gegenstände
}
rooms-load = Betreten
rooms-export-hint = Der ganze Raum kommt in diese eine Datei, zum Aufheben oder Weitergeben. Nichts wird überschrieben.
rooms-import-title = Einen Raum importieren
rooms-import-hint = Die Datei eines exportierten Raums. Man kann sie auch auf das Fenster ziehen.
rooms-found = Exportierte Räume in { $dir }:
rooms-found-none = In { $dir } sind keine exportierten Räume.
rooms-work-delete = Ein Raum wird gelöscht
rooms-work-rename = Ein Raum wird umbenannt
rooms-work-duplicate = Ein Raum wird kopiert
rooms-work-export = Ein Raum wird exportiert
rooms-work-import = Ein Raum wird importiert
rooms-renamed = Der Raum heißt jetzt „{ $name }“.
rooms-duplicated = „{ $name }“ ist eine Kopie des Raums.
rooms-exported = Der Raum steht in { $file }.
rooms-imported = „{ $name }“ ist importiert.
rooms-list-died = Die Liste der Räume konnte nicht gelesen werden; Näheres steht im Protokoll.
