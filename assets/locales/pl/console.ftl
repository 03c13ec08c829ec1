### Konsola i znak światów, w których użyto polecenia oszukującego.

action-console = Konsola
action-workshop = Warsztat: buduj lub chodź

console-entry = Polecenie
console-hint = Polecenie; Tab uzupełnia, help wymienia wszystkie, Esc zamyka
console-no-command = Nie ma polecenia „{ $name }”. help wymienia te, które są.
console-refused = Tego nie można zrobić: { $details }.
console-settled = Cały teren wokół ciebie jest gotowy.
console-unsettled = { $count ->
    [one] Jeszcze jeden kawałek terenu jest tworzony.
    [few] Jeszcze { $count } kawałki terenu są tworzone.
   *[many] Jeszcze { $count } kawałków terenu jest tworzonych.
}
console-no-wait = Tutaj czas płynie sam; czekają tylko skrypty.
console-no-perf = Mierzą tylko skrypty. Podczas gry czas klatki pokazują dane klatek.
console-marked = Ten świat jest odtąd oznaczony: użyto w nim polecenia, które oszukuje.
console-saving = Świat jest zapisywany.
console-not-kept = Ten świat nie ma nazwy, więc nie jest zachowywany.
console-open-already = „{ $name }” jest już otwarty.
console-no-worlds = Nie ma jeszcze zapisanego świata.
console-room-changed = Zmieniono. „room save” to zachowa.
console-room-saved = Pokój jest zapisany.
console-no-versions = Nie ma starszych wersji tego pokoju.
console-world = { $name } ({ $space }, ziarno { $seed })
console-shot-name = Obraz trafia do { $dir }; podaj nazwę bez folderu.

cheats-used = Użyto oszustw

console-help = Polecenia: { $commands }. help POLECENIE mówi więcej o jednym.
console-help-new = Tworzy nowy świat i wchodzi do niego; obecny jest przedtem zapisywany.
console-help-load = Wchodzi do zapisanego świata; obecny jest przedtem zapisywany.
console-help-save = Zapisuje ten świat od razu.
console-help-delete = Usuwa zapisany świat na zawsze.
console-help-list = Wymienia zapisane światy.
console-help-quit = Zapisuje ten świat i kończy grę.
console-help-hold = Trzyma klawisz lub przycisk myszy przez kilka sekund.
console-help-down = Wciska klawisz i trzyma go aż do „up”.
console-help-up = Puszcza klawisz.
console-help-tap = Wciska klawisz i puszcza go.
console-help-click = Wciska przycisk myszy i puszcza go.
console-help-press = Wciska przycisk myszy i trzyma go aż do „release”.
console-help-release = Puszcza przycisk myszy.
console-help-look = Obraca widok jak mysz, o piksele w prawo i w dół.
console-help-aim = Kieruje widok, w stopniach: 0 wzdłuż x, 90 wzdłuż z; w górę dodatnio.
console-help-scroll = Obraca kółko o ząbki.
console-help-wait = Pozwala czasowi płynąć; tylko w skryptach.
console-help-settle = Mówi, czy cały teren wokół ciebie jest gotowy; skrypt na to czeka.
console-help-probe = Podaje stan świata jako jeden wiersz JSON.
console-help-shot = Zachowuje obraz tego, co widzisz, bez konsoli, w folderze zrzutów ekranu.
console-help-set = Zmienia ustawienie tego świata albo jedno z twoich, jak na ekranie ustawień. time, health i fly on oznaczają świat.
console-help-give = Daje ci przedmioty, a w świecie zbierania metry sześcienne rodzaju gruntu. Oznacza świat.
console-help-make = Wytwarza przedmiot z zebranego gruntu.
console-help-teleport = Przenosi cię gdzie indziej, w metrach mapy. Oznacza świat.
console-help-spawn = Stawia w świecie postać, samochód, lampę albo flagę.
console-help-name-flag = Nadaje nazwę najbliższej fladze.
console-help-perf = Mierzy klatki; tylko w skryptach.
console-help-room = Tworzy, otwiera, zapisuje, usuwa lub wymienia pokoje odkształconej przestrzeni i wraca do starszych wersji.
console-help-add = Wstawia coś do otwartego pokoju.
console-help-change = Zmienia coś w otwartym pokoju.
console-help-remove = Usuwa coś z otwartego pokoju.
console-help-group = Tworzy w otwartym pokoju grupę, która niesie swoich członków.
console-help-carry = Sprawia, że rzeczy niesie grupa albo żadna.
console-help-ungroup = Usuwa grupy i zostawia to, co niosły.
console-help-duplicate = Kopiuje rzeczy w otwartym pokoju.
console-help-array = Kopiuje rzeczy w rzędzie albo w kole.
console-help-undo = Cofa ostatnie zmiany otwartego pokoju, a w świecie ostatnie pociągnięcia pędzla.
console-help-redo = Ponawia cofnięte zmiany pokoju.
console-help-help = Mówi o wszystkich poleceniach albo o jednym.
