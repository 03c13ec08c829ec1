### The settings screen. Keys made at run time: setting-<id>.

menu-settings = Ustawienia
settings-search = Szukaj w ustawieniach
settings-nothing-found = Żadne ustawienie nie mówi o „{ $words }”.
settings-reset = Przywróć
settings-reset-named = Przywróć „{ $name }”

settings-group-look = Mysz i widok
settings-group-picture = Obraz
settings-group-world = Przestrzeń
settings-group-comfort = Język, czytelność i wygoda

# { $value } is a number.
unit-degrees = { $value }°
unit-degrees-per-pixel = { $value }° na piksel
unit-chunks = { $value ->
    [0] Automatycznie
    [one] kawałki: { $value }
    [few] kawałki: { $value }
   *[other] kawałki: { $value }
}
unit-notch = { $value } na ząbek
unit-times = { $value } ×

setting-mouse-sensitivity = Czułość myszy
setting-mouse-sensitivity-about = O ile obraca się widok, gdy mysz przesuwa się o jeden piksel.
setting-invert-look = Odwróć górę i dół
setting-invert-look-about = Odsunięcie myszy opuszcza wzrok, jak w samolocie.
setting-field-of-view = Pole widzenia
setting-field-of-view-about = Kąt między górną a dolną krawędzią obrazu. Szeroki pokazuje więcej, ale wszystko jest mniejsze.

setting-preset = Obraz dla
setting-preset-about = Na karcie graficznej teren ma z bliska trawę, zmarszczki, kamyki i warstwy i jest oświetlany punkt po punkcie. Dla procesora ma tylko kolory swojego biomu, co jest szybsze. Automatycznie: zależnie od tego, co rysuje.
setting-preset-auto = Automatycznie
setting-preset-card = Karty graficznej
setting-preset-software = Procesora

setting-quality = Jakość
setting-quality-about = Ile dokładności obraz oddaje za szybkość.
setting-quality-fast = Szybka
setting-quality-balanced = Wyważona
setting-quality-exact = Dokładna
setting-view-distance = Zasięg widoku
setting-view-distance-about = Jak daleko wokół ciebie tworzony jest teren; kawałek ma 32 metry. Automatyczny zasięg to z kartą graficzną ponad 300 metrów. Każdy krok dalej kosztuje pamięć i czas.
setting-render-scale = Rozdzielczość świata
setting-render-scale-about = W jakiej części rozdzielczości okna rysowany jest świat. Teksty pozostają ostre. Automatycznie: cała na karcie graficznej, połowa bez niej.
setting-render-scale-auto = Automatycznie
setting-render-scale-25 = 25%
setting-render-scale-50 = 50%
setting-render-scale-67 = 67%
setting-render-scale-75 = 75%
setting-render-scale-100 = 100%
setting-msaa = Gładkie krawędzie (MSAA)
setting-msaa-about = Bierze kilka próbek piksela tam, gdzie kończy się teren, żeby krawędzie nie miały schodków. Automatycznie: cztery próbki na karcie graficznej, jedna bez niej.
setting-msaa-auto = Automatycznie
setting-msaa-off = Wyłączone
setting-msaa-4x = 4 próbki
setting-shadows = Cienie
setting-shadows-about = Cienie rzucane przez słońce i księżyc. Wysokie są dokładniejsze i bardziej miękkie. Automatycznie: wysokie z kartą graficzną, niskie bez niej.
setting-shadows-auto = Automatycznie
setting-shadows-off = Wyłączone
setting-shadows-low = Niskie
setting-shadows-high = Wysokie
setting-frame-cap = Limit klatek
setting-frame-cap-about = Najwięcej obrazów na sekundę. Mniej to chłodniejszy i cichszy komputer.
setting-frame-cap-30 = 30
setting-frame-cap-60 = 60
setting-frame-cap-90 = 90
setting-frame-cap-120 = 120
setting-frame-cap-144 = 144
setting-frame-cap-240 = 240
setting-frame-cap-none = Bez limitu
setting-vsync = Czekaj na ekran (VSync)
setting-vsync-about = Obraz zmienia się tylko między odświeżeniami ekranu. Bez tego przychodzi wcześniej, ale może być rozdarty.
setting-fullscreen = Pełny ekran
setting-fullscreen-about = Gra wypełnia cały ekran.

setting-curvature-step = Krok krzywizny
setting-curvature-step-about = O ile jeden ząbek kółka przestawia krzywiznę.
setting-hyperbolic-map = Mapa hiperboliczna
setting-hyperbolic-map-about = Mapa, z którą zaczynają się nowe światy hiperboliczne; zmieniona tutaj zmienia się też w świecie, w którym jesteś. Każdy świat pamięta swoją.
setting-hyperbolic-map-raised = Wyniesiona
setting-hyperbolic-map-horizon = Horyzontalna
setting-contour-bands = Poziomice
setting-contour-bands-about = Delikatne linie na terenie, co 8 metrów wysokości. Pokazują, jak wygina się przestrzeń.
setting-compass = Kompas
setting-compass-about = Pokazuje u góry, gdzie jest północ; w światach sferycznych także półkulę i drogę do równika, w światach hiperbolicznych drogę do domu; i gdzie są twoje flagi.
setting-minimap = Minimapa
setting-minimap-about = Okrągła mapa terenu wokół ciebie: wysokości, lampy, flagi i kto jest w pobliżu.
setting-rear-mirror = Lusterko wsteczne
setting-rear-mirror-about = Lusterko u góry widoku znad maski auta. Automatycznie: na karcie graficznej, a nie tam, gdzie rysuje procesor.
setting-rear-mirror-auto = Automatycznie
setting-rear-mirror-off = Wyłączone
setting-rear-mirror-on = Włączone
setting-straight-shots = Proste strzały
setting-straight-shots-about = Pociski lecą po najprostszych liniach przestrzeni, zamiast opadać łukiem.

setting-language = Język
setting-language-about = Język wszystkich tekstów. Systemowy to język twojego komputera, jeśli gra go zna.
setting-language-system = Systemowy
setting-language-en = English
setting-language-pl = Polski
setting-language-de = Deutsch
setting-language-es = Español
setting-language-zh = 中文
setting-ui-scale = Wielkość tekstów i przycisków
setting-ui-scale-about = Jak duże są menu i wskaźniki.
setting-high-contrast = Wysoki kontrast
setting-high-contrast-about = Menu i wskaźniki bielą i żółcią na czerni, bez przezroczystości.
setting-safe-marker = Pierścień dla daltonistów
setting-safe-marker-about = Pierścień wokół kopanego lub budowanego miejsca jest biały z czarnymi brzegami: mówi jasność, a nie kolor.
setting-reduced-motion = Mniej ruchu
setting-reduced-motion-about = Krzywizna przeskakuje zamiast płynąć, menu nie zanikają, głowa się nie ugina, widok znad maski się nie przechyla, a za menu nie płynie żaden świat.
setting-head-dip = Ugięcie przy lądowaniu
setting-head-dip-about = Widok opada lekko, gdy lądujesz po skoku lub upadku.
setting-wind = Wiatr
setting-wind-about = Liście i trawa się kołyszą. Przy mniejszym ruchu stoją nieruchomo.

# The file of the settings. { $file } is a path, { $reason } comes from the system, { $value } from the file.
settings-file-damaged = Plik ustawień był uszkodzony. Obowiązuje to, co dało się odczytać; uszkodzony plik zachowano jako { $file }.
settings-file-newer = Plik ustawień pochodzi z nowszej wersji gry. Obowiązuje to, co jest w nim znane; zachowano go jako { $file }.
settings-file-older = Plik ustawień był ze starszej wersji i został zaktualizowany; stary zachowano jako { $file }.
settings-file-kept = Części pliku ustawień nie dało się użyć; taki, jaki był, zachowano go jako { $file }.
settings-file-value = Ustawienie „{ $name }” ma wartość domyślną: w pliku jest { $value }, czego ono nie przyjmuje.
settings-file-unknown = Plik ustawień mówi o „{ $name }”, czego ta wersja nie zna.
settings-file-input = „{ $name }” jest w pliku ustawień pod { $value }, a to nie klawisz, przycisk ani kółko.
settings-file-profile = Profil klawiszy „{ $name }” z pliku ustawień pominięto.
settings-file-unreadable = Nie udało się odczytać pliku ustawień { $file } ({ $reason }). Obowiązują wartości domyślne, a zmiany nie są zapisywane.
settings-file-stuck = Nie udało się odłożyć pliku ustawień { $file } ({ $reason }). Zostaje, jaki jest, a zmiany nie są zapisywane.
settings-file-no-place = System nie wskazuje miejsca na ustawienia, więc zmiany nie są zapisywane. Wskazuje je --config FILE.
settings-file-unsaved = Nie udało się zapisać ustawień do { $file } ({ $reason }). Obowiązują do końca gry.
settings-file-more = { $count ->
    [one] Jeszcze jednej rzeczy z pliku ustawień nie dało się użyć.
    [few] Jeszcze { $count } rzeczy z pliku ustawień nie dało się użyć.
   *[other] Jeszcze { $count } rzeczy z pliku ustawień nie dało się użyć.
}
settings-not-applied = Tego ustawienia nie dało się zastosować: { $reason }
