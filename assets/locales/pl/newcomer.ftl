### Hints for newcomers, shown one after another in the first world.

hints-look = Rozejrzyj się: { $key }
hints-walk = Chodzenie: { $key }
hints-jump = Skok: { $key }
hints-corner = W każdym rogu spotyka się pięć kwadratów, nie cztery, i stoi tam kamień, od którego odchodzi pięć dróg. Obejdź go i policz je. Przebyte: { $gone } · duża mapa: { $key }
hints-corner-back = Pięć kwadratów i jesteś z powrotem. Na płaskim terenie byłyby cztery.
hints-overhead = Spójrz w górę: ląd nad głową to druga strona tego świata.
hints-talk = Rozmowa z kimś przed tobą: { $key }
hints-car = Wsiadanie do auta, z bliska: { $key }
hints-map = Drugi obraz tej przestrzeni: { $key }
hints-camera = Widok zza pleców i z powrotem: { $key }
hints-light = Jest ciemno. Latarka: { $key }
hints-photo = Robienie zdjęć: { $key }
hints-home = Idź wciąż prosto, w dowolnym kierunku, aż będziesz w domu.
hints-dig = Kopanie, z przytrzymaniem: { $key }
hints-build = Budowanie, z przytrzymaniem: { $key }
hints-make = Budujesz z tego, co wykopiesz. Zrób z tego narzędzia: { $key }, potem „Wytwarzanie”
hints-curve = Inny obraz przestrzeni: { $up } i { $down }
hints-backpack = Otwórz plecak: { $key }
hints-menu = Pauza, ustawienia, wszystkie klawisze: { $key }
hints-footer = { $step } z { $count } · pomiń: { $key }
hints-footer-plain = { $step } z { $count }
hints-stick-left = lewa gałka
hints-stick-right = prawa gałka

menu-skip-hints = Pomiń wskazówki
action-skip-hint = Pomiń wskazówkę
setting-hints = Wskazówki dla początkujących
setting-hints-about = Mówią w świecie po kolei, co można robić. Po ostatniej wyłączają się same; włączone, zaczynają od początku.
