### The screen that tells what the game is and whose work is in it.

menu-about = Über das Spiel
about-game = Antipode ist ein Spiel, in dem man im hyperbolischen, sphärischen und flachen Raum geht, gräbt und baut.
about-version = Version: { $value }
about-adapter = Grafik: { $value }
about-driver = Treiber: { $value }
about-system = System: { $value }
about-built-with = Gebaut mit: { $value }

about-licences = Lizenzen
about-licence-own = Antipode, seine Klänge und sein Symbol sind frei unter der MIT-Lizenz oder der Apache-Lizenz 2.0, nach eigener Wahl.
about-licence-fonts = Schriften: Noto Sans SC und Noto Emoji (SIL Open Font License 1.1), Ubuntu Light (Ubuntu Font Licence 1.0), Hack (MIT und Bitstream Vera), die Symbole von egui (MIT).
about-licence-parts = { $count ->
    [one] Ein Teil von anderen ist eingebaut. Der volle Text seiner Lizenz steht in der Datei THIRD-PARTY.txt neben dem Spiel.
   *[other] { $count } Teile von anderen sind eingebaut. Die vollen Texte ihrer Lizenzen stehen in der Datei THIRD-PARTY.txt neben dem Spiel.
}
