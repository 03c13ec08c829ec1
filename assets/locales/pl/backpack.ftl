### The backpack over the running world.

action-backpack = Plecak

backpack-title = Plecak
# What a slot is called, and a thing with how many there are of it.
backpack-slot = Miejsce { $number }: { $item }
backpack-slot-empty = Miejsce { $number }: puste
backpack-item = { $item } × { $count }
backpack-throw = Wyrzuć
backpack-close = Zamknij
# The page on which things are made of ground, the way to it and back, what is carried of ground, and what a thing takes of a kind out of what is there.
backpack-make = Wytwarzanie
backpack-slots = Miejsca
making-carried = Masz przy sobie:
making-nothing = Nie masz materiału. Kop, żeby go zebrać.
making-where = Węgiel leży w pokładach od 2 m pod ziemią, miedź w żyłach od 4 m, często pod gliną, a kryształ od 7 m, pod żwirem, i w komnatach jaskiń.
making-earth = { $kind } { $volume } m³
making-part = { $kind } { $has } z { $needs } m³
# What the button that makes a thing is called, with what it takes.
making-recipe = Wytwórz { $item }: { $parts }
# What the mouse does, and what the keys do, in a few lines.
backpack-how = Lewy przycisk: weź, odłóż, przeciągnij · Prawy: weź połowę, odłóż sztukę · Shift + lewy: do drugiej części · Poza plecakiem: wyrzuć
backpack-how-keys = Strzałki: ruch · Enter: weź, odłóż · Ctrl + Enter: weź połowę, odłóż sztukę · Shift + Enter: do drugiej części · Cyfra: zamień z paskiem

# What a thing does, in a sentence.
item-gun-about = Strzela nabojem w to, co zasłania celownik.
item-bullet-about = Tym strzela pistolet.
item-lamp-about = Oświetla okolicę. Można ją postawić i znów podnieść.
item-flag-about = Oznacza miejsce. Wbij ją, kliknij ją, żeby nadać jej nazwę, i zabierz, kiedy chcesz: mapa i kompas pokazują do niej drogę.
item-door-about = Jedne z pary. Postaw oboje: co wchodzi w jedne, wychodzi z drugich. Zabierz je prawym przyciskiem.
item-log-about = Kawałek pnia. Postaw ją jak słup albo zrób coś z jej drewna.
item-stone-about = Połóż go, żeby budować, albo zrób coś z jego skały.
item-seed-about = Posadź je w miękkiej ziemi: wyrośnie drzewo tej krainy, z dnia na dzień większe.
item-crumb-about = Układaj je po drodze: przytrzymaj przycisk i idź. Mapa i kompas pokażą drogę powrotną.
item-pickaxe-wood-about = Kopie i buduje, powoli. Tam, gdzie zbiera się materiał, nie kopie miedzi ani kryształu.
item-pickaxe-iron-about = Kopie i buduje trzy razy szybciej niż drewniany. Tam, gdzie zbiera się materiał, kopie też miedź.
item-pickaxe-diamond-about = Kopie i buduje pięć razy szybciej niż drewniany. Tam, gdzie zbiera się materiał, kopie też kryształ.
