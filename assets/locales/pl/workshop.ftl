### Warsztat, w którym buduje się pokoje.

# Pokoje do budowania.
workshop-rooms-none = Nie masz jeszcze własnych pokoi. Utwórz nowy albo zduplikuj jeden z gry na jego stronie (trzy kropki). Do pierwszego jest lekcja.
workshop-rooms-shipped = Pokoje z gry
workshop-rooms-load = Buduj
workshop-rooms-load-named = Buduj w „{ $name }”
workshop-not-own = Ten pokój należy do gry. Zduplikuj go i buduj w kopii.
workshop-not-kept = Nie udało się zapisać pokoju: { $reason }
workshop-not-saved-yet = Twoje zmiany są zachowane, ale plik pokoju pozostaje taki, jaki był, dopóki to nie zostanie naprawione: { $reason }
workshop-kept = Pokój jest zapisywany. Zapisuje się też sam: każdy krok w ciągu dwóch sekund.

# Panele.
workshop-pane-view = Widok
workshop-pane-list = Obiekty
workshop-pane-inspector = Właściwości
workshop-pane-parts = Części
workshop-pane-messages = Komunikaty
workshop-pane-history = Historia
workshop-search = Szukaj
workshop-none-found = Nic się tak nie nazywa.
workshop-rename = Nowa nazwa
workshop-hide = Ukryj „{ $name }”
workshop-fold = Zwiń „{ $name }”
workshop-lock = Zablokuj „{ $name }”
workshop-reset = Przywróć: { $name }
workshop-parts-hint = Kliknięcie stawia część na tym, na co patrzysz.
workshop-all-well = Z tym pokojem wszystko w porządku.
workshop-note-ahead = Ostatnie zmiany tego pokoju nie trafiły do pliku, gdy gra się skończyła. Są z powrotem; nic nie trzeba robić.
workshop-note-changed = Coś innego zmieniło plik tego pokoju, odkąd zapisano go tutaj. To ostatni krok historii; cofnij go, by mieć pokój jak przedtem.
workshop-note-aside = Dziennik tego pokoju był uszkodzony i leży teraz jako { $file }. Może brakować starszych kroków; „Starsze wersje” w historii pokazują, co jeszcze jest.
workshop-in-use = W tym pokoju buduje inne okno gry. Tutaj możesz po nim chodzić; zamknij go najpierw tam, by budować tutaj.
workshop-no-journal = Nie można zapisywać w folderze tego pokoju ({ $reason }). Możesz po nim chodzić; by budować, pozwól zapisywać w folderze i wejdź ponownie.
workshop-drop-elsewhere = Pliki można upuszczać w pokoju, gdy w nim budujesz: Warsztat w menu głównym albo F5 we własnym pokoju.
workshop-drop-choose = Wybierz najpierw, na czym ma leżeć obraz, i weź go jeszcze raz.
workshop-older = Starsze wersje
workshop-older-about = Kliknięcie wstawia tę wersję zamiast pokoju. To krok, który można cofnąć.
workshop-older-none = Nie ma jeszcze starszych wersji. Pół minuty po zmianie powstaje jedna.
workshop-beginning = Początek
workshop-room-itself = Sam pokój
workshop-one = { $name } ({ $kind })
workshop-several = { $count ->
    [one] { $count } obiekt
    [few] { $count } obiekty
    [many] { $count } obiektów
   *[other] { $count } obiektu
}
workshop-status-nothing = Kliknij coś albo leć: przytrzymaj prawy przycisk i W A S D, E, Q.
workshop-status-chosen = Przeciągnij go lub uchwyt · strzałki: jeden krok · F: spójrz · Alt: bez siatki
workshop-status-turn = Przeciągnij pierścień: kroki co 15° · F: spójrz · Alt: bez siatki
workshop-status-scale = Przeciągnij uchwyt: drugi bok zostaje · F: spójrz · Alt: bez siatki
workshop-status-scale-whole = Przeciągnij uchwyt: rośnie wszystko · F: spójrz
workshop-status-flies = W A S D, E i Q lecą, strzałki obracają. V lub Esc kończy.
workshop-status-late = Rysowanie od nowa…
workshop-outside-inside = { $outside } m na zewnątrz, { $inside } m w środku

# Co się robi.
workshop-do-play = Graj
workshop-do-leave = Wyjdź z pokoju
workshop-do-undo = Cofnij
workshop-do-redo = Ponów
workshop-do-move = Przesuń
workshop-do-turn = Obróć
workshop-do-scale = Skaluj
workshop-do-own-axes = Własne osie
workshop-do-snaps = Siatka
workshop-do-on-surfaces = Na powierzchni
workshop-do-copy = Kopiuj
workshop-do-cut = Wytnij
workshop-do-paste = Wklej
workshop-do-duplicate = Duplikuj
workshop-do-array = Powtórz w rzędzie
workshop-do-group = Grupuj
workshop-do-ungroup = Rozgrupuj
workshop-do-delete = Usuń
workshop-do-choose-all = Zaznacz wszystko
workshop-do-focus = Pokaż zaznaczenie
workshop-do-top = Z góry
workshop-do-front = Z przodu
workshop-do-side = Z boku
workshop-do-start = Od miejsca startu
workshop-do-flies = Leć klawiszami
workshop-do-raster = Najpierw szybki obraz
workshop-grid = { $metres } m
workshop-menu-edit = Edycja
workshop-menu-room = Pokój
workshop-menu-view = Widok
workshop-key-ctrl = Ctrl
workshop-key-shift = Shift

# Jednostki.
workshop-unit-metres = { $value } m
workshop-unit-degrees = { $value }°
workshop-unit-times = × { $value }
workshop-unit-plain = { $value }

# Rodzaje obiektów.
workshop-kind-box = pudło
workshop-kind-pyramid = piramida
workshop-kind-ramp = rampa
workshop-kind-cylinder = walec
workshop-kind-ball = kula
workshop-kind-stairs = schody
workshop-kind-arch = łuk
workshop-kind-model = model
workshop-kind-light = lampa
workshop-kind-aberration = przestrzeń
workshop-kind-portal = portal
workshop-kind-sign = znak
workshop-kind-group = grupa

# Części.
workshop-part-box = Pudło
workshop-about-box = Blok o boku jednego metra.
workshop-part-wall = Ściana
workshop-about-wall = 4 m szerokości, 2,5 m wysokości.
workshop-part-floor = Podłoga
workshop-about-floor = Płyta 4 na 4 m.
workshop-part-pyramid = Piramida
workshop-about-pyramid = Wierzchołkiem do góry.
workshop-part-ramp = Rampa
workshop-about-ramp = Wznosi się ku przodowi.
workshop-part-stairs = Schody
workshop-about-stairs = Osiem stopni na 2 m.
workshop-part-arch = Łuk
workshop-about-arch = Blok z bramą.
workshop-part-cylinder = Walec
workshop-about-cylinder = Pionowy, 2 m wysokości.
workshop-part-ball = Kula
workshop-about-ball = Kula o średnicy metra.
workshop-part-light = Lampa
workshop-about-light = Światło z jednego punktu; najwyżej osiem w pokoju.
workshop-part-sign = Znak
workshop-about-sign = Tablica do czytania.
workshop-part-tunnel = Tunel
workshop-about-tunnel = 4 m na zewnątrz, 20 m w środku, z własnymi ścianami. Nic się w nim nie wygina.
workshop-part-hall = Większa przestrzeń
workshop-about-hall = Otwarte pudło, dwa razy większe w środku. Kto wchodzi, jest o połowę mniejszy. Otocz je ścianami albo weź dom.
workshop-part-portals = Para portali
workshop-about-portals = Kto wejdzie w jeden, wyjdzie drugim.

# Właściwości.
workshop-field-name = Nazwa
workshop-field-at = Miejsce
workshop-field-at-group = Miejsce w grupie
workshop-field-turn = Obrót (wokół y, z, x)
workshop-field-size = Rozmiar
workshop-field-radius = Promień
workshop-field-height = Wysokość
workshop-field-steps = Stopnie
workshop-field-opening = Brama
workshop-field-scale = Skala
workshop-field-text = Tekst
workshop-field-colour = Kolor
workshop-field-power = Jasność
workshop-field-checker = W kratkę
workshop-field-checker-colour = Drugi kolor
workshop-field-checker-size = Bok kratki
workshop-field-texture-file = Obraz
workshop-texture-none = Może na nim leżeć obraz: Ctrl+O.
workshop-field-texture-size = Bok obrazu
workshop-field-finish = Powierzchnia
workshop-field-glow = Poświata
workshop-field-box = Rozmiar z zewnątrz
workshop-field-lengths = Co rozciąga
workshop-field-axis = Oś
workshop-field-felt = Długość w środku
workshop-field-times = Rozciągnięcie
workshop-field-times-x = Rozciągnięcie wzdłuż x
workshop-field-times-y = Rozciągnięcie wzdłuż y
workshop-field-times-z = Rozciągnięcie wzdłuż z
workshop-field-thesis = d z pracy dyplomowej
workshop-field-sides = Boki
workshop-field-ways = Działa na
workshop-field-outline = Widoczne krawędzie
workshop-field-to = Prowadzi do
workshop-field-sentence = Co tu jest dziwne
workshop-field-spawn-at = Start
workshop-field-spawn-look = Wzrok na starcie (obrót, pochylenie)
workshop-field-gravity = Grawitacja
workshop-field-sky = Niebo
workshop-field-light = Światło otoczenia
workshop-field-has-sun = Słońce
workshop-field-sun = Gdzie stoi
workshop-field-sun-colour = Kolor słońca
workshop-field-sun-power = Jasność słońca
workshop-field-has-fog = Mgła
workshop-field-fog = Nic nie widać od
workshop-field-fog-colour = Kolor mgły
workshop-choice-finish-matt = Mat
workshop-choice-finish-mirror = Lustro
workshop-choice-finish-glass = Szkło
workshop-choice-lengths-felt = Jedna oś
workshop-choice-lengths-stretch = Wszystkie osie
workshop-choice-axis-x = x (czerwona)
workshop-choice-axis-y = y (zielona)
workshop-choice-axis-z = z (niebieska)
workshop-choice-sides-walls = Ściany
workshop-choice-sides-soft = Otwarte
workshop-choice-sides-snell = Załamujące
workshop-choice-sides-legacy = Reguła z pracy
workshop-choice-sides-1 = Jedna strona
workshop-choice-sides-2 = Obie strony
workshop-choice-ways-both = Każdego, kto wejdzie
workshop-choice-ways-forward = Tylko idących wzdłuż osi

# Co robi przestrzeń.
workshop-told-felt = Na zewnątrz ma { $outside } m, a w środku { $inside } m: { $seconds } s pieszo zamiast { $before }.
workshop-told-smaller = Kto wchodzi, jest { $times } raza mniejszy, więc wszystko jest tyle razy większe. Widoku to nie wygina.
workshop-told-larger = Kto wchodzi, jest { $times } raza większy, więc wszystko jest tyle razy mniejsze. Widoku to nie wygina.
workshop-told-walls = Ma własne ściany; nic się nie wygina, a drzwi są w środku takie jak na zewnątrz.
workshop-told-soft = Kierunki nie zmieniają się na ściankach: idzie się do tego, co się widzi.
workshop-told-snell = Światło załamuje się jak w szkle, a od pewnego kąta odbija.
workshop-told-legacy = Reguła z pracy ma błędy: widok zależy od kierunku patrzenia i nie dochodzi się do tego, co widać.
workshop-told-no-door = Ściany nie zostawiają drzwi, gdy rozciąga się więcej osi. Rozciągnij jedną albo daj otwarte boki.
workshop-told-astigmatic = Proste linie wyglądają przez to na krzywe, bo boki są rozciągnięte nierówno.
workshop-told-grazing = Wzdłuż boków wszystko wygląda na ściśnięte.
workshop-told-itself = Prowadzi do siebie: pokazuje, kto zagląda.
workshop-told-alike = Jest tak duży jak „{ $name }”: kto przejdzie, zachowa rozmiar.
workshop-told-grows = Kto idzie do „{ $name }”, staje się { $times } raza większy.
workshop-told-shrinks = Kto idzie do „{ $name }”, staje się { $times } raza mniejszy.

# Kroki historii.
workshop-step-add = { $count ->
    [one] Dodaj „{ $name }”
    [few] Dodaj obiekty ({ $count })
    [many] Dodaj obiekty ({ $count })
   *[other] Dodaj obiekty ({ $count })
}
workshop-step-remove = { $count ->
    [one] Usuń „{ $name }”
    [few] Usuń obiekty ({ $count })
    [many] Usuń obiekty ({ $count })
   *[other] Usuń obiekty ({ $count })
}
workshop-step-move = { $count ->
    [one] Przesuń „{ $name }”
    [few] Przesuń obiekty ({ $count })
    [many] Przesuń obiekty ({ $count })
   *[other] Przesuń obiekty ({ $count })
}
workshop-step-turn = { $count ->
    [one] Obróć „{ $name }”
    [few] Obróć obiekty ({ $count })
    [many] Obróć obiekty ({ $count })
   *[other] Obróć obiekty ({ $count })
}
workshop-step-pose = { $count ->
    [one] Ustaw „{ $name }”
    [few] Ustaw obiekty ({ $count })
    [many] Ustaw obiekty ({ $count })
   *[other] Ustaw obiekty ({ $count })
}
workshop-step-resize = { $count ->
    [one] Rozmiar „{ $name }”
    [few] Rozmiar obiektów ({ $count })
    [many] Rozmiar obiektów ({ $count })
   *[other] Rozmiar obiektów ({ $count })
}
workshop-step-stretch = { $count ->
    [one] Rozciągnij „{ $name }”
    [few] Rozciągnij obiekty ({ $count })
    [many] Rozciągnij obiekty ({ $count })
   *[other] Rozciągnij obiekty ({ $count })
}
workshop-step-sides = { $count ->
    [one] Boki „{ $name }”
    [few] Boki obiektów ({ $count })
    [many] Boki obiektów ({ $count })
   *[other] Boki obiektów ({ $count })
}
workshop-step-surface = { $count ->
    [one] Powierzchnia „{ $name }”
    [few] Powierzchnia obiektów ({ $count })
    [many] Powierzchnia obiektów ({ $count })
   *[other] Powierzchnia obiektów ({ $count })
}
workshop-step-link = { $count ->
    [one] Połącz „{ $name }”
    [few] Połącz portale ({ $count })
    [many] Połącz portale ({ $count })
   *[other] Połącz portale ({ $count })
}
workshop-step-text = { $count ->
    [one] Tekst „{ $name }”
    [few] Tekst znaków ({ $count })
    [many] Tekst znaków ({ $count })
   *[other] Tekst znaków ({ $count })
}
workshop-step-light = { $count ->
    [one] Światło „{ $name }”
    [few] Światło lamp ({ $count })
    [many] Światło lamp ({ $count })
   *[other] Światło lamp ({ $count })
}
workshop-step-change = { $count ->
    [one] Zmień „{ $name }”
    [few] Zmień obiekty ({ $count })
    [many] Zmień obiekty ({ $count })
   *[other] Zmień obiekty ({ $count })
}
workshop-step-rename = Zmień nazwę „{ $name }” na „{ $new }”
workshop-step-group = Grupa „{ $name }”
workshop-step-carry = { $count ->
    [one] Wyjmij „{ $name }” z grupy
    [few] Wyjmij obiekty z grup ({ $count })
    [many] Wyjmij obiekty z grup ({ $count })
   *[other] Wyjmij obiekty z grup ({ $count })
}
workshop-step-ungroup = { $count ->
    [one] Rozgrupuj „{ $name }”
    [few] Rozgrupuj grupy ({ $count })
    [many] Rozgrupuj grupy ({ $count })
   *[other] Rozgrupuj grupy ({ $count })
}
workshop-step-duplicate = { $count ->
    [one] Duplikuj „{ $name }”
    [few] Duplikuj obiekty ({ $count })
    [many] Duplikuj obiekty ({ $count })
   *[other] Duplikuj obiekty ({ $count })
}
workshop-step-array = { $count ->
    [one] Powtórz „{ $name }”
    [few] Powtórz obiekty ({ $count })
    [many] Powtórz obiekty ({ $count })
   *[other] Powtórz obiekty ({ $count })
}
workshop-step-paste = { $count ->
    [one] Wklej „{ $name }”
    [few] Wklej obiekty ({ $count })
    [many] Wklej obiekty ({ $count })
   *[other] Wklej obiekty ({ $count })
}
workshop-step-room = Sam pokój
workshop-step-spawn = Start
workshop-step-several = Kilka zmian
workshop-step-outside = Zmieniono poza grą
workshop-step-version = Wersja { $when }

# Co może być nie tak.
workshop-finding-not-parallel = „{ $name }” leży częściowo w „{ $other }” i jest inaczej obrócone; jest zamknięte, dopóki osie nie będą równoległe albo jedno nie znajdzie się w całości w drugim.
workshop-finding-too-deep = „{ $name }” leży w zbyt wielu zagnieżdżonych rozciągniętych przestrzeniach, między nimi „{ $other }”; najwyżej osiem.
workshop-finding-walls-across = Ściana „{ $name }” stoi w poprzek „{ $other }” i zamyka przejście; odsuń jedno z nich.
workshop-finding-same-place = „{ $name }” jest w tym samym miejscu co „{ $other }”; przesuń to lub usuń.
workshop-finding-tangled = „{ $name }” leży w tylu innych, że nie wiadomo jak głęboko; rozsuń niektóre.
workshop-finding-no-door = „{ $name }” ma ściany ze wszystkich sześciu stron i nikt nie wejdzie.
workshop-finding-out-of-range = „{ $name }” ma liczbę spoza zakresu.
workshop-finding-no-partner = Portal „{ $name }” nigdzie nie prowadzi: nie ma portalu o nazwie jego celu.
workshop-finding-one-way = Portal „{ $name }” prowadzi do „{ $other }”, który nie prowadzi z powrotem.
workshop-finding-other-sides = „{ $name }” i „{ $other }” nie mają tylu samych stron.
workshop-finding-not-similar = „{ $name }” nie jest podobny do partnera „{ $other }”: nadaj im proporcjonalne rozmiary.
workshop-finding-other-size = „{ $name }” różni się rozmiarem od „{ $other }” ponad 32 razy.
workshop-finding-portal-shape = Rogi „{ $name }” nie tworzą figury wypukłej.
workshop-finding-over-side = Portal „{ $name }” leży na boku „{ $other }”; postaw go całkiem w środku lub na zewnątrz.
workshop-finding-in-odd-box = Portal „{ $name }” stoi w „{ $other }”, gdzie portale nie mogą stać.
workshop-finding-portals-touch = Portale „{ $name }” i „{ $other }” się stykają; rozsuń je co najmniej o milimetr.
workshop-finding-spawn-in-solid = Start jest wewnątrz „{ $name }”.
workshop-finding-spawn-in-air = { $metres ->
    [0] Zaczyna się nad pustką i wypada z pokoju.
    [one] Zaczyna się w powietrzu i spada { $metres } m.
    [few] Zaczyna się w powietrzu i spada { $metres } m.
    [many] Zaczyna się w powietrzu i spada { $metres } m.
   *[other] Zaczyna się w powietrzu i spada { $metres } m.
}
workshop-finding-open-sides = Boki „{ $name }” są otwarte: światło się tam wygina. Zasłoń je albo daj ściany.
workshop-finding-fall-out = Można wypaść z pokoju po { $metres } m marszu.
workshop-finding-unreached = Do „{ $name }” nie da się dojść pieszo od początku.

# Help, and parts of several things.
workshop-reset-short = przywróć
workshop-menu-help = Pomoc
workshop-do-lesson = Weź lekcję
workshop-do-examples = Co jest możliwe
workshop-do-parallel = Bez perspektywy
workshop-do-walls = Ukryj ściany tuneli
workshop-field-times-all = Rozciągnięcie wszystkich osi
workshop-field-group = W grupie
workshop-choice-group-none = Żadnej
workshop-part-house = Dom większy w środku
workshop-about-house = Dom 4 m z drzwiami. W środku jest dwa razy większy, a kto wchodzi, o połowę mniejszy.

# The lesson.
workshop-lesson-title = Lekcja, krok { $number } z { $of }
workshop-lesson-put = Kliknij w częściach „Dom większy w środku”: stanie przed tobą.
workshop-lesson-move = Przeciągnij dom trochę w bok lewym przyciskiem.
workshop-lesson-choose = Kliknij „{ $name }” na liście obiektów: to przestrzeń w domu.
workshop-lesson-stretch = Przesuń suwak „Rozciągnięcie wszystkich osi” w prawo: dom rośnie w środku, a na zewnątrz jest taki sam.
workshop-lesson-enter = Naciśnij Graj (F5) i wejdź drzwiami.
workshop-lesson-walk = Wejdź do domu drzwiami. F5 prowadzi z powrotem do warsztatu.
workshop-lesson-walk-tunnel = Przejdź tunelem i policz kroki. F5 prowadzi z powrotem do warsztatu.
workshop-lesson-done = Zbudowałeś dom większy w środku. W warsztacie (F5) pomoc ma drugą lekcję, o tunelach i portalach, i pokazuje, co jeszcze jest możliwe.
workshop-lesson-skip = Pomiń ten krok
workshop-lesson-end = Zakończ lekcję

# What is possible.
workshop-examples-title = Co jest możliwe
workshop-examples-about = Każdy z nich można skopiować do pokoju i tam zmienić.
workshop-examples-copy = Skopiuj do pokoju
workshop-examples-copy-named = Skopiuj „{ $name }” do pokoju
workshop-examples-close = Zamknij
workshop-example-tunnel-longer = Tunel dłuższy w środku
workshop-example-tunnel-longer-about = 4 m obok, 20 m przez środek.
workshop-example-tunnel-shorter = Tunel krótszy w środku
workshop-example-tunnel-shorter-about = 16 m obok, 2 m przez środek.
workshop-example-house = Dom większy w środku
workshop-example-house-about = Cztery metry na zewnątrz, osiem w środku.
workshop-example-portals = Para portali
workshop-example-portals-about = Kto wejdzie w jeden, wyjdzie drugim.
workshop-example-portals-of-size = Portale różnej wielkości
workshop-example-portals-of-size-about = Kto wyjdzie z dużego, jest trzy razy większy.
workshop-example-falling-loop = Spadanie bez końca
workshop-example-falling-loop-about = Co wpadnie na dole, wypadnie z góry.

# Partners of portals.
workshop-link-to = Przeciągnij na inny portal.
workshop-link-partner = Prowadzi do „{ $name }”: przeciągnij na inny
workshop-told-no-partner = Nigdzie nie prowadzi i jest zamknięty: wybierz portal, do którego prowadzi.
workshop-told-one-way = Jest zamknięty: „{ $name }” nie prowadzi z powrotem.
workshop-told-other-sides = Jest zamknięty: „{ $name }” ma inną liczbę stron.
workshop-told-not-similar = Jest zamknięty: „{ $name }” ma inny kształt. Daj obu ten sam stosunek szerokości do wysokości.
workshop-told-ill-placed = Jest zamknięty: on lub „{ $name }” stoi tam, gdzie nie może. Komunikaty mówią dlaczego.

# Files from the disk.
workshop-do-from-file = Model lub obraz z pliku
workshop-do-keep = Zapisz teraz
workshop-chooser-title = Model lub obraz
workshop-chooser-about = Model (glb, gltf, fbx, obj) stanie przed tobą; obraz (png, jpg) położy się na tym, co zaznaczone.
workshop-chooser-path = Ścieżka
workshop-chooser-open = Otwórz
workshop-chooser-up = Folder wyżej
workshop-chooser-home = Mój folder
workshop-chooser-close = Anuluj
workshop-chooser-reading = Folder jest czytany.
workshop-chooser-empty = Nie ma tu folderu, modelu ani obrazu.
workshop-chooser-folder = folder
workshop-chooser-unread = { $path } nie da się odczytać ({ $reason }). Wpisz inną ścieżkę albo idź dalej od folderu poniżej.
workshop-chooser-unfit = { $path } nie jest modelem (glb, gltf, fbx, obj) ani obrazem (png, jpg). Zapisz go jako jeden z nich albo wybierz inny plik.
workshop-chooser-many = Widać pierwsze { $shown } z { $count }; wpisz ścieżkę innego.

# What fields do, where the pointer rests.
workshop-hover-sides = Co jest na bokach, przez które nikt nie ma przechodzić: ściany, nic albo coś jak szkło.
workshop-hover-ways = Kto przyjdzie z drugiego końca, może zastać przestrzeń tak długą, na jaką wygląda.
workshop-hover-outline = Krawędzie pudła widać także w grze, nie tylko tutaj.
workshop-hover-lengths = Jedna oś wydłuża lub skraca tunel; wszystkie osie powiększają lub zmniejszają wnętrze.
workshop-hover-thesis = Tak liczy rozciągnięcie praca dyplomowa, pierwszy program takich pokoi, odwrotnie: metr w środku zajmuje na zewnątrz 1 + d metrów. 0 nic nie zmienia, 2 to w środku jedna trzecia, −0,8 to pięć razy dłużej.

# The second lesson, and a portal alone.
workshop-do-lesson-doors = Lekcja: tunel i portale
workshop-part-portal = Portal
workshop-about-portal = Prowadzi do siebie, dopóki nie przeciągniesz linii od niego do innego.
workshop-lesson-tunnel = Kliknij w częściach „Tunel”: stanie przed tobą.
workshop-lesson-longer = Gdy zaznaczone jest „{ $name }”, przesuń suwak „Rozciągnięcie” w prawo: w środku będzie dłużej, a na zewnątrz tak samo.
workshop-lesson-portal = Kliknij w częściach „Portal”: to pierwszy z dwóch.
workshop-lesson-portal-again = Kliknij „Portal” jeszcze raz: drugi stanie obok pierwszego.
workshop-lesson-link = Przeciągnij z gałki nad „{ $name }” na środek „{ $other }”: będą prowadzić do siebie nawzajem.
workshop-lesson-through = Naciśnij Graj (F5) i przejdź tunelem.
workshop-lesson-pass = Naciśnij Graj (F5) i wejdź w jeden portal: wyjdziesz drugim.
workshop-lesson-walk-doors = To był tunel. Teraz wejdź w portal. F5 prowadzi z powrotem do warsztatu.
workshop-lesson-done-doors = Zbudowałeś tunel dłuższy w środku i dwa portale, które prowadzą do siebie nawzajem. W warsztacie (F5) pomoc pokaże, co jeszcze jest możliwe.
workshop-link-itself = Prowadzi do siebie: przeciągnij do innego portalu
workshop-link-nowhere = Prowadzi donikąd: przeciągnij do portalu
workshop-hover-own-axes = Uchwyty idą wzdłuż osi przedmiotu, a nie pokoju.
workshop-hover-snaps = Przesuwanie idzie krokami siatki, obrót co 15°. Z Alt bez kroków.
workshop-hover-on-surfaces = Co się przeciąga, leży na powierzchni pod wskaźnikiem: podłogach, ścianach, dachach.

# What parts and their things are called in a room.
workshop-name-bottom = dół
workshop-name-top = góra
workshop-name-falling-loop = pętla spadania
workshop-name-falling-loop-lintel = belka pętli
workshop-name-falling-loop-pillar = słup pętli
workshop-name-falling-loop-rim = obręb pętli
workshop-name-house = dom
workshop-name-house-back = dom - tył
workshop-name-house-ceiling = dom - sufit
workshop-name-house-floor = dom - podłoga
workshop-name-house-front = dom - przód
workshop-name-house-inside = dom - wnętrze
workshop-name-house-lamp = dom - lampa
workshop-name-house-left = dom - lewa ściana
workshop-name-house-light = dom - światło
workshop-name-house-lining-back = dom - okładzina z tyłu
workshop-name-house-lining-front = dom - okładzina z przodu
workshop-name-house-lining-left = dom - okładzina z lewej
workshop-name-house-lining-right = dom - okładzina z prawej
workshop-name-house-right = dom - prawa ściana
workshop-name-house-roof = dom - dach
workshop-name-large-portal = duży portal
workshop-name-large-portal-frame = duża rama portalu
workshop-name-left-post = lewy słupek
workshop-name-lintel = nadproże
workshop-name-long-tunnel = długi tunel
workshop-name-long-tunnel-inside = długi tunel - wnętrze
workshop-name-long-tunnel-slab = długi tunel - płyta
workshop-name-portal = portal
workshop-name-portal-frame = rama portalu
workshop-name-right-post = prawy słupek
workshop-name-short-tunnel = krótki tunel
workshop-name-short-tunnel-inside = krótki tunel - wnętrze
workshop-name-short-tunnel-slab = krótki tunel - płyta
workshop-name-small-portal = mały portal
workshop-name-small-portal-frame = mała rama portalu
workshop-name-tunnel = tunel
workshop-name-hall = przestrzeń
workshop-name-box = pudło
workshop-name-wall = ściana
workshop-name-floor = podłoga
workshop-name-stairs = schody
workshop-name-ramp = rampa
workshop-name-arch = łuk
workshop-name-pyramid = piramida
workshop-name-cylinder = walec
workshop-name-ball = kula
workshop-name-light = światło
workshop-name-sign = znak
workshop-name-group = grupa
workshop-name-model = model
workshop-told-carried = Wszystko, co niesie, ma { $x } m szerokości, { $y } m wysokości i { $z } m głębokości.

# The form of how something is repeated in a row.
workshop-array-count = Ile razy
workshop-array-axis = Wzdłuż
workshop-array-gap = Odstęp
workshop-array-turn = Obrót każdej
workshop-array-make = Utwórz
workshop-array-close = Zamknij
workshop-misread = „{ $text }” to nie liczba: zostaje, jak było.
