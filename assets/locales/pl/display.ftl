### Wskaźniki nad światem.

# Dwa rodzaje współrzędnych; nazwy wierszy, jednym słowem.
display-chart = mapa
display-curved = model
display-flat = przestrzeń płaska: to samo
display-loading = Ląd się pojawia: { $percent }%
display-hemisphere = Półkula { $letter }
display-brush = Pędzel { $radius } m
display-speed = { $speed } km/h

compass-north = N
compass-east = E
compass-south = S
compass-west = W
compass-equator = { $letter } · równik { $metres } m
compass-home = Dom { $metres } m · { $squares ->
    [0] ten kwadrat
    [one] { $squares } kwadrat
    [few] { $squares } kwadraty
   *[other] { $squares } kwadratów
}
compass-flag = { $name } · { $metres } m
compass-way-back = Droga powrotna
display-sighting = Trzy flagi: { $here }° + { $seen }° + { $third }° = { $sum }° · boki { $a }, { $b }, { $c } m

# Czym obraca pokrętło pod kółkiem; kilka słów.
dial-raised = Krzywizna, uniesiona
dial-horizon = Krzywizna, horyzont
dial-bend-hyperbolic = Zgięcie, hiperboliczne
dial-bend-spherical = Zgięcie, sferyczne
dial-bend-flat = Zgięcie, płasko

# Rodzaj przestrzeni, wśród innych słów.
space-hyperbolic = hiperboliczna soczewka
space-hyperbolic-world = świat hiperboliczny
space-euclidean = euklidesowa
space-spherical = sferyczna

# Co trzyma się w ręce.
item-pickaxe-wood = Drewniany kilof
item-pickaxe-iron = Żelazny kilof
item-pickaxe-diamond = Diamentowy kilof
item-gun = Pistolet
item-bullet = Nabój
item-lamp = Lampa
item-flag = Flaga
item-door = Drzwi
item-log = Kłoda
item-stone = Kamień
item-seed = Nasiono
item-crumb = Okruszek
flag-unnamed = Flaga { $number }
flag-name-title = Jak nazywa się ta flaga?
flag-name = Nazwa flagi
flag-name-keep = Zostaw

# Liczby klatki: blok krótkich wierszy, każdy z nazwą jednym słowem i liczbami.
figures-fps = { $frames } kl./s
figures-fps-unknown = kl./s: brak
figures-ms = { $ms } ms
figures-unknown = brak
figures-times = { $fps }   klatka { $frame }   GPU { $gpu }   { $time }
# Między przestrzenią, mapą i jakością.
figures-comma = { ", " }
figures-chunks = kawałki
figures-chunks-are = { $frame } w całości, { $vertex } wierzchołkami, { $refined } zagęszczone
figures-detail = detal
figures-detail-is = { $full } pełne, { $half } połowa, { $quarter } ćwierć, { $eighth } ósma część
figures-drawn = obraz
figures-drawn-are = { $triangles } trójkątów
figures-saved = pominięte
figures-saved-are = { $outside } poza kadrem, { $hidden } zasłonięte, { $small } za małe
figures-error = błąd
figures-error-is = najwyżej { $most } px, daleki ląd { $far } px
figures-dropped = pominięto
figures-dropped-is = { $seconds } s czasu
picture-raised = mapa uniesiona { $value }
picture-horizon = mapa horyzontu { $value }
picture-bend = zgięcie { $sign }{ $value }
quality-fast = szybko
quality-balanced = wyważenie
quality-exact = dokładnie

# In rooms: how far off what is under the crosshair is, and how large one is.
room-ahead = { $felt } m
room-ahead-bent = { $felt } m pieszo, { $scene } m z zewnątrz
room-smaller = Jesteś tu { $times } razy mniejszy niż na zewnątrz
room-larger = Jesteś tu { $times } razy większy niż na zewnątrz
room-smaller-level = Wzdłuż podłogi jesteś tu { $times } razy mniejszy niż na zewnątrz
room-larger-level = Wzdłuż podłogi jesteś tu { $times } razy większy niż na zewnątrz
room-smaller-up = Na wysokość jesteś tu { $times } razy mniejszy niż na zewnątrz
room-larger-up = Na wysokość jesteś tu { $times } razy większy niż na zewnątrz
room-smaller-began = Jesteś { $times } razy mniejszy niż na początku
room-larger-began = Jesteś { $times } razy większy niż na początku
room-keys = { $look }: widok dokładny lub według rozprawy · { $camera }: z tyłu · { $gun }: strzelaj · { $lamp }: postaw lub podnieś lampę · { $lift }: podnieś coś luźnego lub odłóż · { $ball }: rzuć piłkę · { $anew }: zacznij od nowa · { $again }: to samo jeszcze raz · { $edges }: krawędzie pudeł
room-keys-own = { $build }: buduj tutaj
# The ways to look at a room, and what differs in the middle of the picture.
room-look-split = Po lewej według pracy, pierwszej próby takich pokoi, po prawej dokładnie
room-look-thesis = Według reguły pracy, pierwszej próby takich pokoi
room-look-plain = Jak na planie: nic nie jest rozciągnięte ani zgięte
room-half-thesis = praca
room-half-exact = dokładnie
room-differs = Pośrodku: { $exact }, a według pracy { $thesis }.
room-differs-bent = Pośrodku: { $exact }, a według pracy { $thesis }, dokąd światło dociera zgięte o { $bent }°.
room-sky = niebo
room-own = Ten pokój jest twój.
display-brush-shape = { $shape } { $radius } m
display-heap = { $sign }{ $volume } m³ { $kind }
display-ground-left = { $kind }, zostało { $volume } m³
ground-none = Jeszcze nic
ground-found = Jak było
ground-grass = Trawa
ground-soil = Ziemia
ground-sand = Piasek
ground-gravel = Żwir
ground-rock = Skała
ground-ash = Popiół
ground-snow = Śnieg
ground-moss = Mech
ground-clay = Glina
ground-basalt = Bazalt
ground-slate = Łupek
ground-coal = Węgiel
ground-copper = Miedź
ground-crystal = Kryształ
ground-wood = Drewno
brush-ball = Kula
brush-box = Sześcian
brush-cylinder = Walec
brush-flatten = Wyrównanie
brush-smooth = Wygładzanie
