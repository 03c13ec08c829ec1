### Komunikaty, podpowiedzi i to, co może się nie udać. { $path } to plik albo folder, { $details } to zdania po angielsku.

saved = Zapisano

# Odpowiedzi na klawisze.
hint-map-raised = Mapa uniesiona
hint-map-horizon = Mapa horyzontu
hint-no-other-map = Sfera nie ma innej mapy.
hint-bent = { $up } zgina obraz hiperbolicznie, { $down } sferycznie.
hint-unbent = Obraz znów jest płaski.
hint-no-bullets = Nie masz już naboi.
hint-no-place-for-lamp = Lampa musi stać na gruncie, nie dalej niż osiem metrów.
hint-none-there-lamp = Pod celownikiem nie ma lampy.
hint-too-many-lamp = W tym świecie jest za dużo lamp; najpierw jakąś podnieś.
room-hint-no-place-for-lamp = Lampa musi na czymś stanąć: pod celownikiem, nie dalej niż osiem metrów stąd.
room-hint-too-many-lamps = Ten pokój ma już osiem własnych lamp i więcej nie może świecić.
room-hint-nothing-to-lift = Pod celownikiem nie ma w promieniu trzech metrów nic luźnego.
room-hint-too-heavy = To jest za ciężkie, żeby to podnieść; popchnij to.
room-hint-fell-out = Wypadasz z pokoju i zaczynasz od nowa.
room-hint-for-worlds = { $key } jest dla światów. W pokoju pistolet, lampy i piłki są zawsze pod ręką.
hint-no-place-for-flag = Flaga potrzebuje niezbyt stromego terenu, nie dalej niż osiem metrów.
hint-none-there-flag = Pod celownikiem nie ma flagi.
hint-too-many-flag = W tym świecie jest za dużo flag; najpierw jakąś zabierz.
hint-no-place-for-log = Kłoda potrzebuje wolnego miejsca na ziemi, nie dalej niż osiem metrów.
hint-no-place-for-stone = Kamień potrzebuje wolnego miejsca na ziemi, nie dalej niż osiem metrów.
hint-no-place-for-seed = Nasiono potrzebuje miękkiego, równego terenu pod gołym niebem, o krok od innych drzew, nie dalej niż osiem metrów.
hint-no-place-for-crumb = Okruszek potrzebuje gruntu nie dalej niż osiem metrów.
hint-none-there-crumb = Pod celownikiem nie ma okruszka.
hint-last-crumb = To był ostatni okruszek: tu kończy się twój ślad.
hint-too-many-crumb = W tym świecie jest za dużo okruszków; najpierw jeden zabierz.
hint-moved-crumb = Zabrałeś pierwszy okruszek i położyłeś go tutaj: świat ma ich najwyżej 512.
hint-none-there-log = Pod celownikiem nie ma kłody.
hint-none-there-stone = Pod celownikiem nie ma kamienia.
hint-too-many-log = W tym świecie jest za dużo kłód; najpierw jakąś zabierz.
hint-too-many-stone = W tym świecie jest za dużo kamieni; najpierw jakiś zabierz.
hint-too-many-seed = Tu nie da się posadzić więcej drzew.
hint-no-place-for-door = W promieniu ośmiu metrów nie ma gruntu, na którym stanęłyby drzwi.
hint-door-steep = Grunt jest tu zbyt stromy na drzwi: znajdź równe miejsce albo wykop lub zbuduj takie.
hint-door-walled = Tu przeszkadza skała: drzwi potrzebują metra wolnego miejsca z przodu i z tyłu.
hint-door-crowded = Drugie drzwi są zbyt blisko: zostaw między nimi dwa i pół metra.
against-door-steep = zbyt stromo na drzwi
against-door-walled = skała przeszkadza
against-door-crowded = zbyt blisko drugich drzwi
hint-none-there-door = Pod celownikiem nie ma drzwi.
hint-too-many-door = Ten świat ma już swoją parę drzwi; najpierw zabierz jedne.
hint-moved-door = Starsze drzwi stoją teraz tutaj.
hint-no-room = Więcej nie uniesiesz.
hint-too-many-drops = Za dużo rzeczy już leży; najpierw coś podnieś.
hint-died-of-fall = To był zbyt wysoki upadek. Wstaniesz tam, gdzie zaczynasz.
hint-died-of-shot = Zastrzelono cię. Wstaniesz tam, gdzie zaczynasz.
hint-died-of-crash = Zginąłeś w zderzeniu. Wstaniesz tam, gdzie zaczynasz.
hint-died-of-car = Przejechał cię samochód. Wstaniesz tam, gdzie zaczynasz.
hint-died-of-tree = Przygniotło cię drzewo. Wstaniesz tam, gdzie zaczynasz.
hint-no-car-near = W promieniu czterech metrów nie widać samochodu.
hint-look-at-car = Samochód jest obok ciebie. Spójrz na niego, aby wsiąść.
hint-car-too-far = Samochód jest za daleko, żeby wsiąść. Podejdź bliżej.
hint-at-the-wheel = Za kierownicą. Hamulec: { $brake } · Kamera: { $camera } · Klakson: { $horn } · Wysiadanie: { $leave }
hint-fallen-over = Samochód się przewrócił. { $flip } stawia go na koła.
hint-no-way-out = Obok samochodu nie ma wolnego gruntu, żeby wysiąść.
hint-back-again = Wracasz na początek. Wszystko, co masz, nadal jest z tobą.
hint-been-round = Świat został okrążony: po { $metres } m jesteś znów tam, gdzie wcześniej.
hint-nobody-to-talk-to = Przed tobą nie ma z kim rozmawiać.
hint-too-far-to-talk = Są za daleko, żeby rozmawiać. Podejdź bliżej.
hint-waits-to-talk = Usłyszeli cię i czekają. Podejdź bliżej, żeby porozmawiać.
hint-in-the-way = Stoisz na drodze tego, co budujesz, pod sklepieniem. Cofnij się albo weź mniejszy pędzel.
hint-out-of-reach = W zasięgu nie ma nic do kopania. Podejdź bliżej.
hint-too-hard = Za twarde dla tego kilofa: { $kind }. Z tego, co wykopiesz, można zrobić lepszy.
hint-nothing-to-build = Nie masz gruntu do budowania. Najpierw coś wykop.
hint-used-up = Nie ma już z czego budować: { $kind }. Wybierz inny grunt albo wykop więcej.
hint-made = Wytworzono: { $item }
hint-no-coal-yet = Wykopano głęboko i nie znaleziono węgla. Jego pokłady leżą pod mniej więcej połową terenu: kop trzydzieści metrów dalej albo obejrzyj ściany jaskini.
hint-undone = Ostatnie pociągnięcie cofnięte.
hint-undo-none-left = Nie ma już pociągnięcia, które można cofnąć.
hint-undo-away = Ostatnie pociągnięcie jest za daleko, by je cofnąć. Wróć tam, gdzie je zrobiono.
hint-undo-changed = Ostatnie pociągnięcie zostaje: jego grunt od tego czasu się zmienił.
hint-undo-spent = Ostatnie pociągnięcie zostaje: grunt, który dało, został już zużyty.
hint-undo-unreadable = Ostatnie pociągnięcie zostaje: zapisu jego gruntu nie da się teraz odczytać. Sprawdź, czy dysk jest na miejscu, i spróbuj ponownie.

talk-triangle-flat = Ustawiłem trzy lampy, każdą { $side } m od dwóch pozostałych. Kąty, pod którymi widać je od siebie nawzajem, mają razem { $sum }°, jak w szkole.
talk-triangle-pictured = Ustawiłem trzy lampy, każdą { $side } m od dwóch pozostałych. Kąty, pod którymi widać je od siebie nawzajem, mają razem { $sum }°: ląd jest płaski, zakrzywiony jest tylko jego obraz.
talk-hello = Cześć! { $words }
talk-triangle-more = Ustawiłem trzy lampy, każdą { $side } m od dwóch pozostałych. Kąty, pod którymi widać je od siebie nawzajem, mają razem { $sum }°, więcej niż 180.
talk-triangle-less = Postawiłem trzy lampy, każdą { $side } m od pozostałych. Widziane jedna z drugiej dają razem { $sum }°, mniej niż 180.
talk-horizon-lower = Widzisz grunt { $away } m stąd, tak wysoki jak tutaj? Wygląda o { $angle }° niżej niż na płaskim obrazie.
talk-horizon-flat = Widzisz grunt { $away } m stąd, tak wysoki jak tutaj? Leży dokładnie tam, gdzie pokazuje go płaski obraz.
talk-horizon-higher = Widzisz grunt { $away } m stąd, tak wysoki jak tutaj? Wygląda o { $angle }° wyżej niż na płaskim obrazie.
talk-home-round = Do domu jest stąd { $there } m, a w drugą stronę, dookoła świata, { $round } m.
talk-home-straight = Do domu jest stąd { $there } m. Ten ląd nie ma końca, więc nie da się go obejść.
talk-home-squares = Do domu jest stąd { $there } m, { $squares ->
    [0] w tym samym kwadracie
    [one] { $squares } kwadrat dalej
    [few] { $squares } kwadraty dalej
   *[other] { $squares } kwadratów dalej
}. Każda inna droga jest dłuższa, a większość dużo dłuższa.
talk-land = Na tej wysokości w promieniu { $within } m jest { $times } razy tyle lądu co na płaskim terenie. Niżej jest go więcej.
talk-square = Przejdź { $side } m, skręć w prawo i powtórz to cztery razy. Na płaskim terenie byłbyś z powrotem; tutaj kończysz { $gap } m od miejsca, z którego wyszedłeś.

# Tytuły tego, co się nie udało, i zdania, gdy nic więcej nie wiadomo.
open-failed = Nie udało się otworzyć świata
open-died = Coś zawiodło podczas wczytywania; resztę mówi dziennik.
save-failed = Nie udało się zapisać świata
close-died = Coś zawiodło podczas zapisywania świata; resztę mówi dziennik.
not-saved = Ostatnie zmiany w świecie nie są zapisane.
not-saved-yet = Nie udało się zapisać świata; następny zapis spróbuje ponownie.
save-unfinished = Ostatnia zmiana terenu albo jej zapis nie zakończyły się na czas; wszystko, co zapisano wcześniej, jest bezpieczne.

# Zapisy.
save-in-use = Świat „{ $world }” jest w użyciu: otwarto go w innym oknie gry albo w innym programie. Zamknij go tam i spróbuj ponownie.
save-newer = Świat „{ $world }” zapisała nowsza wersja gry. Zaktualizuj grę, aby w nim grać; nic nie zostało zmienione.
save-damaged = Część tego świata jest uszkodzona. Reszty można używać; „antipode saves repair” przywraca starszą kopię tej części, jeśli taka istnieje. ({ $details })
save-part-damaged = Część tego świata jest uszkodzona. Reszty można używać; „antipode saves verify” mówi, co to jest, a „antipode saves repair” przywraca starszą kopię, jeśli istnieje.
save-unreadable = Zapis { $path } jest uszkodzony i nie można go odczytać. „antipode saves repair” ratuje to, co całe, i zachowuje ten plik.
save-file-missing = Brakuje pliku { $path } tego świata. Jeśli masz jego kopię, odłóż ją na miejsce; w przeciwnym razie „antipode saves repair” odtworzy świat, jeśli to możliwe.
save-vanished = Zapis { $path } zniknął: jego folder przeniesiono, usunięto albo zastąpiono, gdy świat był otwarty, więc nie można w nim nic zapisać. Przenieś folder z powrotem i zapisz ponownie.
save-not-found = Nie ma już świata „{ $world }”.
saves-busy = Inna gra tworzy, przemianowuje albo importuje świat w { $path } i nie może skończyć. Spróbuj ponownie za chwilę albo zamknij tę drugą grę.
saves-not-a-folder = { $path } to plik, więc nie może w nim być światów. Wybierz folder za pomocą --saves-dir.
file-exists = { $path } już istnieje i nie zostanie nadpisane. Wybierz inną nazwę albo przenieś to gdzie indziej.
disk-full = Brak miejsca, aby zapisać { $path }. Zwolnij trochę miejsca i zapisz ponownie; to, co zapisano wcześniej, jest bezpieczne.
not-writable = Nie można zapisać { $path }: jest tylko do odczytu albo należy do kogoś innego. Zmień uprawnienia albo wybierz inne miejsce za pomocą --saves-dir.
not-readable = Nie można odczytać { $path }: zabraniają tego uprawnienia albo plik należy do kogoś innego. Zmień uprawnienia albo wybierz inne miejsce przez --saves-dir.
archive-refused = Nie można zaimportować { $path }: to nie jest wyeksportowany świat albo plik jest uszkodzony. Reszta jest w dzienniku.
unknown-space = Świat „{ $world }” leży w przestrzeni, której ta wersja nie zna. Nowsza wersja gry może go otworzyć.
unknown-generator = Teren świata „{ $world }” powstaje w sposób, którego ta wersja nie zna. Nowsza wersja gry może go otworzyć.
impossible-radius = Świat „{ $world }” podaje, że jego przestrzeń ma promień { $radius } m, a tego nie może mieć żaden świat. Jego plik pozostał nietknięty.
player-damaged = Gracz w zapisie był uszkodzony; zaczynasz znów od początku. Twój ląd jest taki, jaki był.
unknown-item = Zapis zawiera przedmiot, którego ta wersja nie zna („{ $item }”); nie widać go, ale w zapisie pozostaje.
unknown-records = { $count ->
    [one] Zapis zawiera jedną rzecz z nowszej wersji; nie widać jej, ale w zapisie pozostaje.
    [few] Zapis zawiera { $count } rzeczy z nowszej wersji; nie widać ich, ale w zapisie pozostają.
   *[many] Zapis zawiera { $count } rzeczy z nowszej wersji; nie widać ich, ale w zapisie pozostają.
}
unknown-map = Zapis wymienia mapę, której ta wersja nie zna („{ $map }”); pokazana jest inna.
more-damaged = { $count ->
    [one] Uszkodzone jest jeszcze jedno miejsce w tym świecie; „antipode saves verify” je poda.
    [few] Uszkodzone są jeszcze { $count } miejsca w tym świecie; „antipode saves verify” je poda.
   *[many] Uszkodzonych jest jeszcze { $count } miejsc w tym świecie; „antipode saves verify” je poda.
}
land-trouble = Z lądem jest coś nie tak. { $details }
other-trouble = To się nie udało. { $details }

# Nazwy światów.
name-empty = Nadaj światu nazwę.
name-blank = Nazwa potrzebuje co najmniej jednego widocznego znaku.
name-too-long = { $chars ->
    [one] Nazwa ma jeden znak; mieści się najwyżej { $most }.
    [few] Nazwa ma { $chars } znaki; mieści się najwyżej { $most }.
   *[many] Nazwa ma { $chars } znaków; mieści się najwyżej { $most }.
}
name-unprintable = Nazwa zawiera znak, którego nie można pokazać ({ $code }).
name-taken = Jest już świat o nazwie „{ $name }”.
room-name-taken = Jest już pokój o nazwie „{ $name }”.

# Karta graficzna.
no-adapter = Na tym komputerze nie znaleziono karty graficznej, której gra może użyć ({ $found }). Zainstaluj jej sterownik albo uruchom grę z --adapter software.
adapter-lost = Utracono kartę graficzną. Twój świat jest bezpieczny; uruchom grę ponownie.
adapter-refuses = Karta graficzna odrzuca shader gry ({ $details }). Zaktualizuj jej sterownik albo uruchom grę z --adapter software.
adapter-reopened = Utracono kartę graficzną i otwarto ją ponownie.

# Why the game was started anew after its graphics had failed for good, and what draws now.
graphics-title = Grafika zawiodła
graphics-lost = Utracono kartę graficzną i nie dało się jej ponownie otworzyć. Twój świat jest zapisany.
graphics-software = Gra uruchomiła się na nowo i teraz rysuje procesor, co jest wolniejsze. Aby znów spróbować z kartą graficzną, zamknij grę i uruchom ją jeszcze raz.

# Awaria poprzedniego uruchomienia gry.
crash-title = Gra uległa awarii
crash = Gra nieoczekiwanie się zatrzymała i uruchomiła na nowo. Twoje światy i pokoje są takie, jak przy ostatnim zapisie, najwyżej kilka sekund wcześniej. To, co wiadomo o awarii, jest w { $report }.

# Biomy: samą nazwę widać po wejściu.
biome-volcanic = Ziemia wulkaniczna
biome-desert = Pustynia
biome-forest = Las
biome-toxic = Toksyczna równina
biome-jungle = Dżungla
biome-tundra = Tundra
biome-wetland = Mokradła
biome-crags = Turnie
biome-shore = Wybrzeże
biome-cave = Jaskinia
