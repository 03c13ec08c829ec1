### Zrzuty ekranu i tryb fotograficzny.

action-screenshot = Zrzut ekranu
action-photo-mode = Tryb fotograficzny

picture-kept = Obraz zapisany jako { $file }
picture-disk-full = Nie ma już miejsca, by zapisać obraz { $path }. Zwolnij trochę miejsca i spróbuj ponownie.
picture-read-only = Nie można zapisać obrazu { $path }: to miejsce jest tylko do odczytu albo należy do kogoś innego.
picture-not-kept = Nie udało się zachować obrazu { $path }: { $reason }
picture-not-taken = Nie udało się zrobić obrazu: { $reason }

photo-title = Tryb fotograficzny
photo-field-of-view = Pole widzenia
photo-time = Pora dnia
photo-curvature = Krzywizna
photo-bend = Wygięcie
photo-figures = Ukryj postacie
photo-thirds = Siatka trójpodziału
photo-size = Rozmiar
photo-size-times = { $times } × ({ $width } × { $height })
photo-save = Zapisz obraz
photo-leave = Wyjdź
photo-fly = { $keys } – lot, przytrzymany przycisk myszy obraca widok, strzałki chodzą po tej liście
photo-saving = Zapisywanie: { $percent } %
photo-left = tryb fotograficzny opuszczono, zanim był gotowy
photo-dial = { $value }
