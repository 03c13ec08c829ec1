### Menu główne, formularz nowego świata i okna dialogowe.

# Kolumna przycisków.
menu-resume = Wróć do gry
menu-save = Zapisz
menu-save-and-quit = Zapisz i wyjdź do menu
menu-begin-anew = Zacznij od nowa
menu-build-here = Buduj tutaj
menu-leave-room = Wyjdź z pokoju
menu-new-game = Nowa gra
menu-load = Wczytaj
menu-delete = Usuń
menu-rooms = Pokoje
menu-workshop = Warsztat
menu-controls = Sterowanie
menu-quit = Wyjdź z gry
version = Wersja { $version }
adapter-software = Nie znaleziono karty graficznej: rysuje procesor ({ $adapter }), w { $percent }% rozdzielczości okna. Pomaga małe okno lub zasięg widzenia.
running-world = { $name } · ziarno { $seed }

back = Wstecz
ok = OK
percent = { $percent }%

# Formularz nowego świata.
name = Nazwa
name-hint = Jak ma się nazywać?
name-offered = Świat { $number }
name-free = Ta nazwa jest wolna.
name-not-shown = Niektórych znaków nie da się tu pokazać: obok będzie stała nazwa folderu.
space = Przestrzeń
geometry-hyperbolic = Hiperboliczna soczewka
geometry-hyperbolic-about = Płaski, bezkresny ląd widziany w zakrzywionej przestrzeni: opada wokół tak mocno, jak obrócisz kółko.
geometry-hyperbolic-world = Świat hiperboliczny
geometry-hyperbolic-world-about = Więcej miejsca niż na płaskim lądzie: w każdym rogu spotyka się pięć kwadratów, a droga powrotna nie jest tą, której się spodziewasz.
geometry-euclidean = Euklidesowa
geometry-euclidean-about = Płaska przestrzeń, bezkresna i znajoma.
geometry-spherical = Sferyczna
geometry-spherical-about = Zamknięty świat: ląd wznosi się i spotyka nad głową, a obchodząc go dookoła, wracasz do domu.
mode = Tryb
mode-creative = Kreatywny
mode-creative-about = Wszystkie narzędzia od początku; budowanie nic nie kosztuje.
mode-gathering = Zbieranie
mode-gathering-about = Budujesz z tego, co wykopiesz, i robisz z tego narzędzia.
seed = Ziarno (opcjonalne)
seed-hint = Liczba albo słowa
seed-random = Puste zostanie wylosowane.
seed-is = Ziarno to { $seed }.
seed-too-large = Za duże: największe ziarno to 18446744073709551615.
seed-not-whole = Liczba musi być całkowita i nieujemna: same cyfry.
seed-too-long = Za długie: najwyżej 64 znaki.
seed-unprintable = Tylko znaki, które da się wyświetlić.
radius-metres = { $metres } m
radius = Wielkość: promień świata
radius-moonlet = Księżycik
radius-moon = Księżyc
radius-planet = Planeta
radius-named = { $name }, { $metres } m
radius-round = Dookoła: { $metres } m, { $minutes } minuty marszu.
squares = Wielkość: szerokość kwadratu, pięć wokół każdego rogu
squares-wide = { $metres } m
squares-land = W promieniu { $metres } m jest { $times } razy tyle lądu co na płaskim terenie.
create = Utwórz
needs-name = Potrzebna poprawna nazwa
needs-seed = Potrzebne poprawne ziarno

# Świat, którego nie udało się zapisać przed wyjściem.
unsaved-title = Świat nie jest zapisany
unsaved-again = Spróbuj ponownie
unsaved-stay = Zostań w świecie
unsaved-leave = Wyjdź bez zapisu

# Na co gracz czeka.
busy-opening = Otwieranie
busy-opening-about = Świat jest wczytywany z dysku.
busy-opening-room = Pokój jest wczytywany z dysku, a jego obraz przygotowywany.
busy-land = Tworzenie lądu
busy-saving = Zapisywanie
busy-saving-about = Twój świat jest zapisywany na dysku.
busy-leaving = Wychodzenie
