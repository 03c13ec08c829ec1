### The screen that tells what the game is and whose work is in it.

menu-about = O grze
about-game = Antipode to gra o chodzeniu, kopaniu i budowaniu w przestrzeni hiperbolicznej, sferycznej i płaskiej.
about-version = Wersja: { $value }
about-adapter = Grafika: { $value }
about-driver = Sterownik: { $value }
about-system = System: { $value }
about-built-with = Zbudowano z użyciem: { $value }

about-licences = Licencje
about-licence-own = Antipode, jej dźwięki i ikona są wolne na licencji MIT albo Apache 2.0, do wyboru.
about-licence-fonts = Czcionki: Noto Sans SC i Noto Emoji (SIL Open Font License 1.1), Ubuntu Light (Ubuntu Font Licence 1.0), Hack (MIT i Bitstream Vera), ikony egui (MIT).
about-licence-parts = { $count ->
    [one] W grę wbudowano jedną cudzą część. Pełny tekst jej licencji jest w pliku THIRD-PARTY.txt obok gry.
    [few] W grę wbudowano { $count } cudze części. Pełne teksty ich licencji są w pliku THIRD-PARTY.txt obok gry.
   *[other] W grę wbudowano { $count } cudzych części. Pełne teksty ich licencji są w pliku THIRD-PARTY.txt obok gry.
}
