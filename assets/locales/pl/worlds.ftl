### The lists of worlds.

worlds-none = Nie ma jeszcze żadnych światów. Nowa gra tworzy pierwszy.
worlds-load-named = Wczytaj „{ $name }”
worlds-delete-named = Usuń „{ $name }”
worlds-manage = Zarządzaj „{ $name }”
worlds-running = Teraz w grze
worlds-running-no-delete = Ten świat jest teraz w grze. Najpierw zapisz go i wyjdź do menu, potem go usuń.
worlds-running-no-change = Ten świat jest teraz w grze. Najpierw zapisz go i wyjdź do menu, potem go zmień.
worlds-cannot-load-title = Nie można wczytać „{ $name }”
worlds-cannot-delete-title = Nie można teraz usunąć „{ $name }”

# What is known of a world.
worlds-played = czas gry: { $time }
worlds-played-briefly = poniżej minuty
worlds-played-minutes = { $minutes } min
worlds-played-hours = { $hours } godz. { $minutes } min
worlds-size = { $megabytes } MB
worlds-size-small = { $kilobytes } kB
worlds-edits = { $count ->
    [0] nic jeszcze nie zmieniono
    [one] { $count } zmieniony blok
    [few] { $count } zmienione bloki
   *[other] { $count } zmienionych bloków
}
worlds-edits-unknown = trwa liczenie zmienionych bloków

# The page of one world.
worlds-load = Wczytaj
worlds-rename = Zmień nazwę
worlds-duplicate = Powiel
worlds-export = Eksportuj
worlds-open-folder = Otwórz folder
worlds-delete = Usuń
worlds-keep = Zachowaj
worlds-cancel = Anuluj
worlds-delete-question = Usunąć „{ $name }”?
worlds-delete-final = Tego nie da się cofnąć.
worlds-rename-title = Zmiana nazwy „{ $name }”
worlds-new-name = Nowa nazwa
worlds-name-free = Tej nazwy można użyć.
worlds-export-title = Eksport „{ $name }”
worlds-file = Plik
worlds-export-hint = Cały świat trafia do tego jednego pliku, na pamiątkę lub dla innych. Niczego się nie nadpisuje.

# Worlds from files.
worlds-import = Importuj
worlds-import-title = Import świata
worlds-import-do = Importuj
worlds-import-hint = Plik wyeksportowanego świata. Można go też upuścić na okno gry.
worlds-found = Wyeksportowane światy w { $dir }:
worlds-found-none = W { $dir } nie ma wyeksportowanych światów.
worlds-import-named = { $name } ({ $size })
worlds-folder-named = { $name } (folder)
worlds-folder-above = Folder wyżej
worlds-folder-unread = Nie da się odczytać { $dir } ({ $reason }). Wybierz inny folder albo wpisz ścieżkę.
worlds-export-folders = Plik trafi do { $dir }. Inny folder:

# Work on the saves, and what it came to.
worlds-work-delete = Usuwanie świata
worlds-work-rename = Zmiana nazwy świata
worlds-work-duplicate = Kopiowanie świata
worlds-work-export = Eksportowanie świata
worlds-work-import = Importowanie świata
worlds-renamed = Świat nazywa się teraz „{ $name }”.
worlds-duplicated = „{ $name }” jest kopią świata.
worlds-exported = Świat zapisano w { $file }.
worlds-imported = Zaimportowano „{ $name }”.
worlds-list-died = Nie udało się odczytać listy światów; reszta jest w dzienniku.
worlds-work-died = Coś się przy tym nie powiodło; reszta jest w dzienniku.
worlds-folder-failed = Nie udało się otworzyć folderu { $dir }: { $reason }. Można go otworzyć ręcznie.
worlds-folder-no-program = nie znaleziono programu, który pokazuje foldery
worlds-folder-refused = system nie znalazł niczego, co by go pokazało

# Rooms of deformed space, where they are told in other words than worlds.
rooms-none = Nie ma jeszcze żadnych pokojów.
rooms-new = Nowy pokój
rooms-load-named = Wejdź do „{ $name }”
rooms-running = Jesteś w nim teraz
rooms-running-no-change = Jesteś teraz w tym pokoju. Najpierw z niego wyjdź, potem go zmień.
rooms-shipped = Ten pokój należy do gry. Powiel go i zmień kopię.
rooms-objects = { $count ->
    [one] { $count } przedmiot
    [few] { $count } przedmioty
   *[other] { $count } przedmiotów
}
rooms-load = Wejdź
rooms-export-hint = Cały pokój trafia do tego jednego pliku, na pamiątkę lub dla innych. Niczego się nie nadpisuje.
rooms-import-title = Import pokoju
rooms-import-hint = Plik wyeksportowanego pokoju. Można go też upuścić na okno gry.
rooms-found = Wyeksportowane pokoje w { $dir }:
rooms-found-none = W { $dir } nie ma wyeksportowanych pokojów.
rooms-work-delete = Usuwanie pokoju
rooms-work-rename = Zmiana nazwy pokoju
rooms-work-duplicate = Kopiowanie pokoju
rooms-work-export = Eksportowanie pokoju
rooms-work-import = Importowanie pokoju
rooms-renamed = Pokój nazywa się teraz „{ $name }”.
rooms-duplicated = „{ $name }” jest kopią pokoju.
rooms-exported = Pokój zapisano w { $file }.
rooms-imported = Zaimportowano „{ $name }”.
rooms-list-died = Nie można było odczytać listy pokojów; reszta jest w dzienniku.
