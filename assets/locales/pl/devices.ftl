### Dźwięk i pady. Klucze tworzone w czasie działania: setting-<id>, key-<id>.

settings-group-sound = Dźwięk
settings-group-pad = Pad
unit-percent = { $value }%
unit-degrees-per-second = { $value }° na sekundę

setting-volume-master = Głośność
setting-volume-master-about = Wszystkiego razem.
setting-volume-effects = Kroki i narzędzia
setting-volume-effects-about = Jak głośne są kroki, lądowania, kopanie i budowanie.
setting-volume-ambience = Wiatr, dzień i noc
setting-volume-ambience-about = Jak głośny jest wiatr, a także ptaki w dzień i świerszcze w nocy.
setting-volume-music = Muzyka
setting-volume-music-about = Jak głośna jest muzyka; jest cicha i ma długie przerwy.
setting-volume-interface = Menu i pasek
setting-volume-interface-about = Jak głośne są dźwięki menu i paska.
setting-mute-elsewhere = Cisza w tle
setting-mute-elsewhere-about = Nic nie słychać, gdy klawiaturę ma inne okno.
setting-pad-look-speed = Obracanie gałką
setting-pad-look-speed-about = Jak szybko obraca się widok przy prawej gałce wychylonej do końca.
setting-pad-invert-look = Odwróć górę i dół gałki
setting-pad-invert-look-about = Wychylenie prawej gałki od siebie patrzy w dół, jak w samolocie.
setting-pad-dead-zone = Spoczynek gałek
setting-pad-dead-zone-about = Jak daleko od środka może stać gałka i wciąż uchodzić za puszczoną. Większa wartość pomaga, gdy widok sam się obraca.

sound-none = Nie ma urządzenia dźwiękowego; gra działa dalej bez niego. Podłączone później zostanie użyte.
sound-lost = Urządzenie dźwiękowe zniknęło; gra działa dalej bez niego i czeka na nowe.
sound-left-out = Tę grę zbudowano bez dźwięku.

pad-connected = Podłączono pad: { $name }
pad-disconnected = Odłączono pad: { $name }

key-pad-south = Pad A, dolny
key-pad-east = Pad B, prawy
key-pad-west = Pad X, lewy
key-pad-north = Pad Y, górny
key-pad-left-bumper = Pad lewy przycisk górny
key-pad-right-bumper = Pad prawy przycisk górny
key-pad-left-trigger = Pad lewy spust
key-pad-right-trigger = Pad prawy spust
key-pad-select = Pad Select
key-pad-start = Pad Start
key-pad-left-stick = Pad lewa gałka wciśnięta
key-pad-right-stick = Pad prawa gałka wciśnięta
key-pad-up = Pad krzyżak w górę
key-pad-down = Pad krzyżak w dół
key-pad-left = Pad krzyżak w lewo
key-pad-right = Pad krzyżak w prawo
