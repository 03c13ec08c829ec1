### Die Anzeige über der Welt.

display-chart = Karte
display-curved = Modell
display-flat = flacher Raum: dasselbe
display-loading = Das Land kommt: { $percent } %
display-hemisphere = Halbkugel { $letter }
display-brush = Pinsel { $radius } m
display-speed = { $speed } km/h

compass-north = N
compass-east = O
compass-south = S
compass-west = W
compass-equator = { $letter } · Äquator { $metres } m
compass-home = Zuhause { $metres } m · { $squares ->
    [0] dieses Quadrat
    [one] { $squares } Quadrat
   *[other] { $squares } Quadrate
}
compass-flag = { $name } · { $metres } m
compass-way-back = Rückweg
display-sighting = Drei Fahnen: { $here }° + { $seen }° + { $third }° = { $sum }° · Seiten { $a }, { $b }, { $c } m

dial-raised = Krümmung, angehoben
dial-horizon = Krümmung, Horizont
dial-bend-hyperbolic = Biegung, hyperbolisch
dial-bend-spherical = Biegung, sphärisch
dial-bend-flat = Biegung, flach

space-hyperbolic = hyperbolische Linse
space-hyperbolic-world = hyperbolische Welt
space-euclidean = euklidisch
space-spherical = sphärisch

item-pickaxe-wood = Holzspitzhacke
item-pickaxe-iron = Eisenspitzhacke
item-pickaxe-diamond = Diamantspitzhacke
item-gun = Pistole
item-bullet = Kugel
item-lamp = Lampe
item-flag = Fahne
item-door = Tür
item-log = Baumstück
item-stone = Stein
item-seed = Samen
item-crumb = Brotkrume
flag-unnamed = Fahne { $number }
flag-name-title = Wie heißt diese Fahne?
flag-name = Name der Fahne
flag-name-keep = So lassen

figures-fps = { $frames } FPS
figures-fps-unknown = FPS k. A.
figures-ms = { $ms } ms
figures-unknown = k. A.
figures-times = { $fps }   Bild { $frame }   GPU { $gpu }   { $time }
figures-comma = { ", " }
figures-chunks = Stücke
figures-chunks-are = { $frame } als Ganzes, { $vertex } je Ecke, { $refined } verfeinert
figures-detail = Detail
figures-detail-is = { $full } voll, { $half } halb, { $quarter } viertel, { $eighth } achtel
figures-drawn = Bild
figures-drawn-are = { $triangles } Dreiecke
figures-saved = gespart
figures-saved-are = { $outside } außerhalb, { $hidden } verdeckt, { $small } zu klein
figures-error = Fehler
figures-error-is = höchstens { $most } px, fernes Land { $far } px
figures-dropped = verworfen
figures-dropped-is = { $seconds } s Zeit
picture-raised = angehobene Karte { $value }
picture-horizon = Horizontkarte { $value }
picture-bend = Biegung { $sign }{ $value }
quality-fast = schnell
quality-balanced = ausgewogen
quality-exact = genau

# In rooms: how far off what is under the crosshair is, and how large one is.
room-ahead = { $felt } m
room-ahead-bent = { $felt } m zu Fuß, { $scene } m von außen
room-smaller = Du bist hier { $times }-mal kleiner als draußen
room-larger = Du bist hier { $times }-mal größer als draußen
room-smaller-level = Am Boden entlang bist du hier { $times }-mal kleiner als draußen
room-larger-level = Am Boden entlang bist du hier { $times }-mal größer als draußen
room-smaller-up = In der Höhe bist du hier { $times }-mal kleiner als draußen
room-larger-up = In der Höhe bist du hier { $times }-mal größer als draußen
room-smaller-began = Du bist { $times }-mal kleiner als am Anfang
room-larger-began = Du bist { $times }-mal größer als am Anfang
room-keys = { $look }: die genaue Ansicht oder die der Dissertation · { $camera }: von hinten · { $gun }: schießen · { $lamp }: Lampe hinstellen oder aufheben · { $lift }: Loses heben oder absetzen · { $ball }: Ball werfen · { $anew }: von vorn · { $again }: dies noch einmal · { $edges }: Kanten der Kästen
room-keys-own = { $build }: hier bauen
# The ways to look at a room, and what differs in the middle of the picture.
room-look-split = Links nach der Regel der Arbeit, dem ersten Versuch mit solchen Räumen, rechts genau
room-look-thesis = Nach der Regel der Arbeit, dem ersten Versuch mit solchen Räumen
room-look-plain = Wie auf dem Plan: nichts ist gedehnt oder gebogen
room-half-thesis = Arbeit
room-half-exact = genau
room-differs = In der Mitte: { $exact }, und nach der Arbeit { $thesis }.
room-differs-bent = In der Mitte: { $exact }, und nach der Arbeit { $thesis }, wo das Licht um { $bent }° gebogen ankommt.
room-sky = der Himmel
room-own = Dieser Raum gehört dir.
display-brush-shape = { $shape } { $radius } m
display-heap = { $sign }{ $volume } m³ { $kind }
display-ground-left = { $kind }, noch { $volume } m³
ground-none = Noch nichts
ground-found = Wie vorgefunden
ground-grass = Gras
ground-soil = Erde
ground-sand = Sand
ground-gravel = Kies
ground-rock = Fels
ground-ash = Asche
ground-snow = Schnee
ground-moss = Moos
ground-clay = Ton
ground-basalt = Basalt
ground-slate = Schiefer
ground-coal = Kohle
ground-copper = Kupfer
ground-crystal = Kristall
ground-wood = Holz
brush-ball = Kugel
brush-box = Würfel
brush-cylinder = Zylinder
brush-flatten = Einebnen
brush-smooth = Glätten
