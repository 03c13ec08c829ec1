### The screen that tells what the game is and whose work is in it.

menu-about = Acerca del juego
about-game = Antipode es un juego de caminar, cavar y construir en el espacio hiperbólico, esférico y plano.
about-version = Versión: { $value }
about-adapter = Gráficos: { $value }
about-driver = Controlador: { $value }
about-system = Sistema: { $value }
about-built-with = Hecho con: { $value }

about-licences = Licencias
about-licence-own = Antipode, sus sonidos y su icono son libres bajo la licencia MIT o la licencia Apache 2.0, a elección.
about-licence-fonts = Fuentes: Noto Sans SC y Noto Emoji (SIL Open Font License 1.1), Ubuntu Light (Ubuntu Font Licence 1.0), Hack (MIT y Bitstream Vera), iconos de egui (MIT).
about-licence-parts = { $count ->
    [one] Incluye una parte de otros autores. El texto completo de su licencia está en el archivo THIRD-PARTY.txt junto al juego.
   *[other] Incluye { $count } partes de otros autores. Los textos completos de sus licencias están en el archivo THIRD-PARTY.txt junto al juego.
}
