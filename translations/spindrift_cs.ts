<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="cs" sourcelanguage="en">
<context>
    <name>CoverReading</name>
    <message>
        <source>Snow %1</source>
        <translation>Sníh %1</translation>
    </message>
    <message>
        <source>water %1</source>
        <translation>voda %1</translation>
    </message>
    <message>
        <source>No snow</source>
        <translation>Bez sněhu</translation>
    </message>
    <message>
        <source>surface %1</source>
        <translation>povrch %1</translation>
    </message>
    <message>
        <source>exposure %1</source>
        <translation>vystavení %1</translation>
    </message>
</context>
<context>
    <name>Edits</name>
    <message>
        <source>Collect files</source>
        <translation>Sebrat soubory</translation>
    </message>
    <message>
        <source>Switch on %1</source>
        <translation>Zapnout: %1</translation>
    </message>
    <message>
        <source>Switch off %1</source>
        <translation>Vypnout: %1</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>Malovat: %1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Přidat %1</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importovat %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Odebrat %1</translation>
    </message>
    <message>
        <source>Reorder nodes</source>
        <translation>Změnit pořadí uzlů</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Přejmenovat %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Změnit %1</translation>
    </message>
    <message>
        <source>Set key of %1</source>
        <translation>Nastavit klíč: %1</translation>
    </message>
    <message>
        <source>Remove key of %1</source>
        <translation>Odebrat klíč: %1</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>Posunout klíče</translation>
    </message>
    <message>
        <source>Revert %1</source>
        <translation>Vrátit %1</translation>
    </message>
</context>
<context>
    <name>FlowReading</name>
    <message>
        <source>Flow %1 m/s</source>
        <translation>Proud %1 m/s</translation>
    </message>
    <message>
        <source>%1 m above the ground</source>
        <translation>%1 m nad zemí</translation>
    </message>
</context>
<context>
    <name>Properties</name>
    <message>
        <source>Position</source>
        <translation>Poloha</translation>
    </message>
    <message>
        <source>Place of the eye in local metres.</source>
        <translation>Místo oka v místních metrech.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cíl</translation>
    </message>
    <message>
        <source>Point the camera looks at.</source>
        <translation>Bod, na který kamera hledí.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Zorné pole</translation>
    </message>
    <message>
        <source>Vertical angle of view.</source>
        <translation>Svislý úhel záběru.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>The view that pictures are rendered from.</source>
        <translation>Pohled, ze kterého se obrazy vykreslují.</translation>
    </message>
    <message>
        <source>Quartz</source>
        <translation>Křemen</translation>
    </message>
    <message>
        <source>Sand</source>
        <translation>Písek</translation>
    </message>
    <message>
        <source>Soil</source>
        <translation>Půda</translation>
    </message>
    <message>
        <source>Vegetation</source>
        <translation>Vegetace</translation>
    </message>
    <message>
        <source>Rock</source>
        <translation>Skála</translation>
    </message>
    <message>
        <source>Ice</source>
        <translation>Led</translation>
    </message>
    <message>
        <source>Asphalt</source>
        <translation>Asfalt</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Voda</translation>
    </message>
    <message>
        <source>Base type</source>
        <translation>Základní typ</translation>
    </message>
    <message>
        <source>Ground where nothing is painted.</source>
        <translation>Povrch tam, kde není nic namalováno.</translation>
    </message>
    <message>
        <source>Painted file</source>
        <translation>Malovaný soubor</translation>
    </message>
    <message>
        <source>8-bit PNG of the terrain&apos;s size with one ground type per pixel; written when the scene is saved.</source>
        <translation>Osmibitové PNG velikosti terénu s jedním typem povrchu na pixel; zapisuje se při uložení scény.</translation>
    </message>
    <message>
        <source>Base temperature</source>
        <translation>Základní teplota</translation>
    </message>
    <message>
        <source>Ground temperature where nothing is painted.</source>
        <translation>Teplota povrchu tam, kde není nic namalováno.</translation>
    </message>
    <message>
        <source>GeoTIFF of the terrain&apos;s size with temperatures in K; written when the scene is saved.</source>
        <translation>GeoTIFF velikosti terénu s teplotami v K; zapisuje se při uložení scény.</translation>
    </message>
    <message>
        <source>Ground types</source>
        <translation>Typy povrchu</translation>
    </message>
    <message>
        <source>Painted materials of the ground.</source>
        <translation>Malované materiály povrchu.</translation>
    </message>
    <message>
        <source>Ground temperature</source>
        <translation>Teplota povrchu</translation>
    </message>
    <message>
        <source>Painted temperature of the ground.</source>
        <translation>Malovaná teplota povrchu.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Šířka</translation>
    </message>
    <message>
        <source>Width of pictures.</source>
        <translation>Šířka obrazů.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Height of pictures.</source>
        <translation>Výška obrazů.</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Vzorky</translation>
    </message>
    <message>
        <source>Samples per pixel against jagged edges: 1, 2, 4 or 8.</source>
        <translation>Vzorky na pixel proti zubatým hranám: 1, 2, 4 nebo 8.</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Expozice</translation>
    </message>
    <message>
        <source>Brightness in stops: +1 is twice as bright.</source>
        <translation>Jas ve stupních clony: +1 je dvakrát světlejší.</translation>
    </message>
    <message>
        <source>Snowfall haze</source>
        <translation>Zákal sněžením</translation>
    </message>
    <message>
        <source>How much of its real extinction falling snow shows in the distance: 1 is what the eye would see, less keeps the view open.</source>
        <translation>Jaký díl skutečného zeslabení světla padající sníh v dálce ukáže: 1 je to, co by vidělo oko, méně ponechá výhled otevřený.</translation>
    </message>
    <message>
        <source>Show flakes</source>
        <translation>Ukázat vločky</translation>
    </message>
    <message>
        <source>Draw the falling flakes.</source>
        <translation>Kreslit padající vločky.</translation>
    </message>
    <message>
        <source>Show caption</source>
        <translation>Ukázat popisek</translation>
    </message>
    <message>
        <source>Print the caption and the credit line on pictures.</source>
        <translation>Tisknout na obrazy popisek a uvedení zdroje.</translation>
    </message>
    <message>
        <source>Caption</source>
        <translation>Popisek</translation>
    </message>
    <message>
        <source>Text printed on pictures.</source>
        <translation>Text tištěný na obrazy.</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Snímková frekvence</translation>
    </message>
    <message>
        <source>Pictures per second of film.</source>
        <translation>Obrazy za sekundu filmu.</translation>
    </message>
    <message>
        <source>Time scale</source>
        <translation>Měřítko času</translation>
    </message>
    <message>
        <source>Seconds of weather per second of film. Cover and mass use weather time, flakes on screen film time.</source>
        <translation>Sekundy počasí na sekundu filmu. Pokrývka a hmotnost běží v čase počasí, vločky na obrazovce v čase filmu.</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>První snímek</translation>
    </message>
    <message>
        <source>First frame shown and exported; the simulation itself starts at 0.</source>
        <translation>První zobrazený a exportovaný snímek; sama simulace začíná od 0.</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Poslední snímek</translation>
    </message>
    <message>
        <source>Last frame shown and exported.</source>
        <translation>Poslední zobrazený a exportovaný snímek.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semínko</translation>
    </message>
    <message>
        <source>Start of the random numbers: same scene, same seed, same result.</source>
        <translation>Počátek náhodných čísel: stejná scéna, stejné semínko, stejný výsledek.</translation>
    </message>
    <message>
        <source>Exposure rays</source>
        <translation>Paprsky expozice</translation>
    </message>
    <message>
        <source>Rays per cover cell that measure how open it lies; the error falls with the square root.</source>
        <translation>Paprsky na buňku pokrývky, které měří, jak otevřeně leží; chyba klesá s odmocninou.</translation>
    </message>
    <message>
        <source>New snow density</source>
        <translation>Hustota nového sněhu</translation>
    </message>
    <message>
        <source>0 takes it from the air temperature.</source>
        <translation>0 ji odvodí z teploty vzduchu.</translation>
    </message>
    <message>
        <source>Holds below</source>
        <translation>Drží pod</translation>
    </message>
    <message>
        <source>Slopes flatter than this keep all the snow that reaches them.</source>
        <translation>Svahy mírnější než toto udrží všechen sníh, který na ně dopadne.</translation>
    </message>
    <message>
        <source>Sheds above</source>
        <translation>Shazuje nad</translation>
    </message>
    <message>
        <source>Slopes steeper than this keep none.</source>
        <translation>Svahy strmější než toto neudrží žádný.</translation>
    </message>
    <message>
        <source>Cover noise</source>
        <translation>Nerovnost pokrývky</translation>
    </message>
    <message>
        <source>Unevenness of the cover; its mean is zero.</source>
        <translation>Nestejnoměrnost pokrývky; její průměr je nula.</translation>
    </message>
    <message>
        <source>Checkpoint every</source>
        <translation>Záchytný bod po</translation>
    </message>
    <message>
        <source>Frames between full saves of the state, from which an edit restarts.</source>
        <translation>Snímky mezi úplnými uloženími stavu, od nichž se po úpravě pokračuje.</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Obrazy</translation>
    </message>
    <message>
        <source>Size and look of pictures.</source>
        <translation>Velikost a vzhled obrazů.</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulace</translation>
    </message>
    <message>
        <source>Time, range and accuracy of the simulation.</source>
        <translation>Čas, rozsah a přesnost simulace.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Soubor</translation>
    </message>
    <message>
        <source>Raster file with the elevation model.</source>
        <translation>Rastrový soubor s výškovým modelem.</translation>
    </message>
    <message>
        <source>EPSG code</source>
        <translation>Kód EPSG</translation>
    </message>
    <message>
        <source>Coordinate system; 0 takes the one named in the file.</source>
        <translation>Souřadnicový systém; 0 převezme ten, který uvádí soubor.</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Velikost buňky</translation>
    </message>
    <message>
        <source>Distance of the heights in files without coordinates; 0 takes the file&apos;s, or 1 m.</source>
        <translation>Vzdálenost výšek v souborech bez souřadnic; 0 převezme údaj souboru, jinak 1 m.</translation>
    </message>
    <message>
        <source>Height unit</source>
        <translation>Jednotka výšky</translation>
    </message>
    <message>
        <source>Metres per unit of height in files that name no unit, such as 16-bit PNG.</source>
        <translation>Metry na jednotku výšky v souborech, které jednotku neuvádějí, jako šestnáctibitové PNG.</translation>
    </message>
    <message>
        <source>Marks holes</source>
        <translation>Značí díry</translation>
    </message>
    <message>
        <source>The hole value marks cells without height, in files that cannot name one.</source>
        <translation>Hodnota díry značí buňky bez výšky v souborech, které ji samy neumějí uvést.</translation>
    </message>
    <message>
        <source>Hole value</source>
        <translation>Hodnota díry</translation>
    </message>
    <message>
        <source>Value of cells without height, in units of the file.</source>
        <translation>Hodnota buněk bez výšky v jednotkách souboru.</translation>
    </message>
    <message>
        <source>Vertical scale</source>
        <translation>Svislé měřítko</translation>
    </message>
    <message>
        <source>Factor on the heights above the lowest point.</source>
        <translation>Násobek výšek nad nejnižším bodem.</translation>
    </message>
    <message>
        <source>Fine cover cell</source>
        <translation>Jemná buňka pokrývky</translation>
    </message>
    <message>
        <source>Size of the snow cover cells near models; elsewhere the cover has the terrain&apos;s cells.</source>
        <translation>Velikost buněk sněhové pokrývky u modelů; jinde má pokrývka buňky terénu.</translation>
    </message>
    <message>
        <source>Fine cover margin</source>
        <translation>Okraj jemné pokrývky</translation>
    </message>
    <message>
        <source>How far round a model the fine cover reaches.</source>
        <translation>Jak daleko kolem modelu jemná pokrývka sahá.</translation>
    </message>
    <message>
        <source>Credit line</source>
        <translation>Uvedení zdroje</translation>
    </message>
    <message>
        <source>Source of the data, printed on pictures.</source>
        <translation>Zdroj dat, tištěný na obrazy.</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>Podle souboru</translation>
    </message>
    <message>
        <source>Y is up</source>
        <translation>Nahoru míří Y</translation>
    </message>
    <message>
        <source>Z is up</source>
        <translation>Nahoru míří Z</translation>
    </message>
    <message>
        <source>Model file (glTF, OBJ, PLY).</source>
        <translation>Soubor modelu (glTF, OBJ, PLY).</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Svislá osa</translation>
    </message>
    <message>
        <source>Which way is up in the model file.</source>
        <translation>Kterým směrem je v souboru modelu nahoru.</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Jednotka souboru</translation>
    </message>
    <message>
        <source>Metres per unit of the file; 0 takes what the format says.</source>
        <translation>Metry na jednotku souboru; 0 převezme údaj formátu.</translation>
    </message>
    <message>
        <source>Place in local metres: east, north, up.</source>
        <translation>Místo v místních metrech: východ, sever, výška.</translation>
    </message>
    <message>
        <source>Stand on ground</source>
        <translation>Stát na zemi</translation>
    </message>
    <message>
        <source>The height counts from the terrain under the model.</source>
        <translation>Výška se počítá od terénu pod modelem.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Otočení</translation>
    </message>
    <message>
        <source>Turn about the x, y and z axes, in that order.</source>
        <translation>Otočení kolem os x, y a z, v tomto pořadí.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Měřítko</translation>
    </message>
    <message>
        <source>Factor along each axis.</source>
        <translation>Násobek podél každé osy.</translation>
    </message>
    <message>
        <source>Cover cell</source>
        <translation>Buňka pokrývky</translation>
    </message>
    <message>
        <source>Size of the snow cover cells on this model.</source>
        <translation>Velikost buněk sněhové pokrývky na tomto modelu.</translation>
    </message>
    <message>
        <source>Catches snow</source>
        <translation>Zachytává sníh</translation>
    </message>
    <message>
        <source>Snow lies on the parts that face up; otherwise the model only shelters what is below it.</source>
        <translation>Sníh leží na částech obrácených vzhůru; jinak model jen kryje to, co je pod ním.</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Terén</translation>
    </message>
    <message>
        <source>An elevation model; the ground of the scene.</source>
        <translation>Výškový model; půda scény.</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>An imported object: a house, a tree, a car.</source>
        <translation>Importovaný předmět: dům, strom, auto.</translation>
    </message>
    <message>
        <source>Air temperature</source>
        <translation>Teplota vzduchu</translation>
    </message>
    <message>
        <source>Temperature of the air; sets the density of new snow.</source>
        <translation>Teplota vzduchu; určuje hustotu nového sněhu.</translation>
    </message>
    <message>
        <source>Wind speed</source>
        <translation>Rychlost větru</translation>
    </message>
    <message>
        <source>Mean wind; tilts the fall of the snow.</source>
        <translation>Střední vítr; sklání pád sněhu.</translation>
    </message>
    <message>
        <source>Wind from</source>
        <translation>Vítr od</translation>
    </message>
    <message>
        <source>Direction the wind comes from: 0 north, 90 east.</source>
        <translation>Směr, odkud vítr vane: 0 sever, 90 východ.</translation>
    </message>
    <message>
        <source>Precipitation</source>
        <translation>Srážky</translation>
    </message>
    <message>
        <source>Water that falls on level ground; it rules picture and cover alike.</source>
        <translation>Voda, která dopadá na vodorovnou plochu; řídí obraz i pokrývku.</translation>
    </message>
    <message>
        <source>Sun azimuth</source>
        <translation>Azimut slunce</translation>
    </message>
    <message>
        <source>Direction of the sun from north through east.</source>
        <translation>Směr slunce od severu přes východ.</translation>
    </message>
    <message>
        <source>Sun elevation</source>
        <translation>Výška slunce</translation>
    </message>
    <message>
        <source>Height of the sun above the horizon.</source>
        <translation>Výška slunce nad obzorem.</translation>
    </message>
    <message>
        <source>Cloud cover</source>
        <translation>Oblačnost</translation>
    </message>
    <message>
        <source>0 is a clear sky, 1 an overcast one; clouds soften the sun.</source>
        <translation>0 je jasná obloha, 1 zatažená; oblaka slunce změkčují.</translation>
    </message>
    <message>
        <source>Dendrite aggregates, unrimed</source>
        <translation>Shluky dendritů, bez námrazy</translation>
    </message>
    <message>
        <source>Dendrite aggregates, densely rimed</source>
        <translation>Shluky dendritů, silně ojíněné</translation>
    </message>
    <message>
        <source>Hexagonal graupel</source>
        <translation>Šestihranné krupky</translation>
    </message>
    <message>
        <source>Type of snow</source>
        <translation>Druh sněhu</translation>
    </message>
    <message>
        <source>Sets mass and fall speed of the flakes (Locatelli and Hobbs 1974).</source>
        <translation>Určuje hmotnost a rychlost pádu vloček (Locatelli a Hobbs 1974).</translation>
    </message>
    <message>
        <source>Rate factor</source>
        <translation>Násobek intenzity</translation>
    </message>
    <message>
        <source>Factor on the weather&apos;s precipitation.</source>
        <translation>Násobek srážek počasí.</translation>
    </message>
    <message>
        <source>Fall spread</source>
        <translation>Rozptyl pádu</translation>
    </message>
    <message>
        <source>Half-angle of the cone of fall directions; softens the edge of shelter.</source>
        <translation>Poloviční úhel kužele směrů pádu; změkčuje okraj závětří.</translation>
    </message>
    <message>
        <source>Flutter amplitude</source>
        <translation>Rozkmit třepotání</translation>
    </message>
    <message>
        <source>Sideways swing of a flake about its path.</source>
        <translation>Boční výkyv vločky kolem její dráhy.</translation>
    </message>
    <message>
        <source>Flutter rate</source>
        <translation>Rychlost třepotání</translation>
    </message>
    <message>
        <source>Angular rate of the swing, rad/s.</source>
        <translation>Úhlová rychlost výkyvu, rad/s.</translation>
    </message>
    <message>
        <source>Flake box</source>
        <translation>Kvádr vloček</translation>
    </message>
    <message>
        <source>Flakes drawn</source>
        <translation>Kreslené vločky</translation>
    </message>
    <message>
        <source>Weather</source>
        <translation>Počasí</translation>
    </message>
    <message>
        <source>Air, wind, precipitation and sun.</source>
        <translation>Vzduch, vítr, srážky a slunce.</translation>
    </message>
    <message>
        <source>Snowfall</source>
        <translation>Sněžení</translation>
    </message>
    <message>
        <source>Falling snow and the cover it lays.</source>
        <translation>Padající sníh a pokrývka, kterou tvoří.</translation>
    </message>
    <message>
        <source>Particles, PLY</source>
        <translation>Částice, PLY</translation>
    </message>
    <message>
        <source>Particles, VTP and PVD</source>
        <translation>Částice, VTP a PVD</translation>
    </message>
    <message>
        <source>Snow cover of the terrain, GeoTIFF</source>
        <translation>Sněhová pokrývka terénu, GeoTIFF</translation>
    </message>
    <message>
        <source>PNG, 8 bit</source>
        <translation>PNG, 8 bitů</translation>
    </message>
    <message>
        <source>PNG, 16 bit</source>
        <translation>PNG, 16 bitů</translation>
    </message>
    <message>
        <source>OpenEXR, linear, 32 bit</source>
        <translation>OpenEXR, lineární, 32 bitů</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formát</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Sítě</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Trojúhelníky</translation>
    </message>
    <message>
        <source>Instances</source>
        <translation>Instance</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materiály</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Textury</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Velikost</translation>
    </message>
    <message>
        <source>Lowest point</source>
        <translation>Nejnižší bod</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednotka</translation>
    </message>
    <message>
        <source>West, south</source>
        <translation>Západ, jih</translation>
    </message>
    <message>
        <source>East, north</source>
        <translation>Východ, sever</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Výšky</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Bez dat</translation>
    </message>
    <message>
        <source>Coordinate system</source>
        <translation>Souřadnicový systém</translation>
    </message>
    <message>
        <source>Credit</source>
        <translation>Zdroj dat</translation>
    </message>
    <message>
        <source>Dry snow</source>
        <translation>Suchý sníh</translation>
    </message>
    <message>
        <source>Wet snow</source>
        <translation>Mokrý sníh</translation>
    </message>
    <message>
        <source>Slush</source>
        <translation>Sněhová břečka</translation>
    </message>
    <message>
        <source>Cross fluid, thinning</source>
        <translation>Crossova kapalina, řídnoucí</translation>
    </message>
    <message>
        <source>Cross fluid, thickening</source>
        <translation>Crossova kapalina, houstnoucí</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Vlastní</translation>
    </message>
    <message>
        <source>What flows: a preset, or custom for the numbers of a flow material node. The presets&apos; numbers and sources stand in the documentation of flow materials.</source>
        <translation>Co teče: předvolba, nebo vlastní materiál s čísly z uzlu materiálu toku. Čísla předvoleb a jejich zdroje jsou v dokumentaci materiálů toku.</translation>
    </message>
    <message>
        <source>Flow material node that a custom material takes its numbers from.</source>
        <translation>Uzel materiálu toku, ze kterého vlastní materiál bere svá čísla.</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Obrys</translation>
    </message>
    <message>
        <source>Corners of the release area in plan, local metres east and north. It must not cross itself.</source>
        <translation>Rohy odtrhové plochy v půdorysu, místní metry na východ a na sever. Obrys nesmí křížit sám sebe.</translation>
    </message>
    <message>
        <source>8-bit PNG of the terrain&apos;s size, 1 where the slab is released and 255 elsewhere; it adds to the outline and is written when the scene is saved.</source>
        <translation>8bitové PNG o velikosti terénu, 1 tam, kde se deska utrhne, jinde 255; přidává se k obrysu a zapisuje se při uložení scény.</translation>
    </message>
    <message>
        <source>Slab depth</source>
        <translation>Tloušťka desky</translation>
    </message>
    <message>
        <source>Depth of the slab that breaks loose.</source>
        <translation>Tloušťka desky, která se utrhne.</translation>
    </message>
    <message>
        <source>Vertical depth</source>
        <translation>Svislá tloušťka</translation>
    </message>
    <message>
        <source>The depth is measured vertically; otherwise along the slope&apos;s normal, as release depths are given.</source>
        <translation>Tloušťka se měří svisle; jinak po normále svahu, jak se tloušťky odtrhu udávají.</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Hustota</translation>
    </message>
    <message>
        <source>Density of the slab; 0 takes the material&apos;s.</source>
        <translation>Hustota desky; 0 bere hustotu materiálu.</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiál</translation>
    </message>
    <message>
        <source>Custom material</source>
        <translation>Vlastní materiál</translation>
    </message>
    <message>
        <source>Release time</source>
        <translation>Čas odtrhu</translation>
    </message>
    <message>
        <source>Film time at which the slab breaks loose; it is not there before.</source>
        <translation>Čas filmu, ve kterém se deska utrhne; předtím tam není.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Úsečka</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Kruh</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Tvar</translation>
    </message>
    <message>
        <source>A line such as a crest, or a disc such as a pipe&apos;s mouth.</source>
        <translation>Úsečka, například hrana přelivu, nebo kruh, například ústí trubky.</translation>
    </message>
    <message>
        <source>One end of the line, or the centre of the disc.</source>
        <translation>Jeden konec úsečky, nebo střed kruhu.</translation>
    </message>
    <message>
        <source>Line&apos;s end</source>
        <translation>Konec úsečky</translation>
    </message>
    <message>
        <source>The other end of the line.</source>
        <translation>Druhý konec úsečky.</translation>
    </message>
    <message>
        <source>Heights count from the terrain under each point.</source>
        <translation>Výšky se počítají od terénu pod každým bodem.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Poloměr</translation>
    </message>
    <message>
        <source>Radius of the disc.</source>
        <translation>Poloměr kruhu.</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Rychlost</translation>
    </message>
    <message>
        <source>Direction and speed at which fluid enters. Of a disc only the direction counts: its speed follows from flow and radius.</source>
        <translation>Směr a rychlost, kterou kapalina vstupuje. U kruhu platí jen směr: rychlost plyne z průtoku a poloměru.</translation>
    </message>
    <message>
        <source>Flow per metre</source>
        <translation>Průtok na metr</translation>
    </message>
    <message>
        <source>Volume a second and metre of the line.</source>
        <translation>Objem za sekundu na metr úsečky.</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Tok</translation>
    </message>
    <message>
        <source>Volume a second of the disc.</source>
        <translation>Objem za sekundu z kruhu.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Začátek</translation>
    </message>
    <message>
        <source>Film time of the first inflow.</source>
        <translation>Čas filmu, kdy přítok začíná.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Konec</translation>
    </message>
    <message>
        <source>Film time at which inflow ends.</source>
        <translation>Čas filmu, kdy přítok končí.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Rovina</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Kvádr</translation>
    </message>
    <message>
        <source>All behind a plane, or all within a box, is taken out.</source>
        <translation>Odstraní se vše za rovinou, nebo vše uvnitř kvádru.</translation>
    </message>
    <message>
        <source>A point of the plane, or the centre of the box.</source>
        <translation>Bod roviny, nebo střed kvádru.</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normála</translation>
    </message>
    <message>
        <source>Direction from the plane to the side that stays.</source>
        <translation>Směr od roviny ke straně, která zůstává.</translation>
    </message>
    <message>
        <source>Edges of the box along x, y and z.</source>
        <translation>Hrany kvádru podél x, y a z.</translation>
    </message>
    <message>
        <source>Stands still</source>
        <translation>Stojí na místě</translation>
    </message>
    <message>
        <source>Moves by its keys</source>
        <translation>Pohybuje se podle klíčů</translation>
    </message>
    <message>
        <source>Moved by what hits it</source>
        <translation>Pohybuje jím to, co do něj narazí</translation>
    </message>
    <message>
        <source>Model that is solid for the flow.</source>
        <translation>Model, který je pro tok pevný.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Pohyb</translation>
    </message>
    <message>
        <source>Whether the body stands, follows the keys of its model, or is moved by flow, gravity and collisions.</source>
        <translation>Zda těleso stojí, sleduje klíče svého modelu, nebo jím pohybuje tok, tíže a srážky.</translation>
    </message>
    <message>
        <source>Density of a moved body.</source>
        <translation>Hustota pohyblivého tělesa.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Tření</translation>
    </message>
    <message>
        <source>Coulomb&apos;s coefficient against flow, ground and other bodies.</source>
        <translation>Coulombův součinitel proti toku, zemi a jiným tělesům.</translation>
    </message>
    <message>
        <source>Restitution</source>
        <translation>Restituce</translation>
    </message>
    <message>
        <source>Share of the speed that a collision gives back.</source>
        <translation>Podíl rychlosti, který srážka vrátí.</translation>
    </message>
    <message>
        <source>Start velocity</source>
        <translation>Počáteční rychlost</translation>
    </message>
    <message>
        <source>Velocity of a moved body at the start.</source>
        <translation>Rychlost pohyblivého tělesa na začátku.</translation>
    </message>
    <message>
        <source>Start spin</source>
        <translation>Počáteční otáčení</translation>
    </message>
    <message>
        <source>Angular velocity of a moved body at the start, rad/s.</source>
        <translation>Úhlová rychlost pohyblivého tělesa na začátku, rad/s.</translation>
    </message>
    <message>
        <source>Avalanche release</source>
        <translation>Odtrh laviny</translation>
    </message>
    <message>
        <source>A slab of snow that breaks loose.</source>
        <translation>Sněhová deska, která se utrhne.</translation>
    </message>
    <message>
        <source>Water source</source>
        <translation>Zdroj vody</translation>
    </message>
    <message>
        <source>A crest or a mouth where water enters.</source>
        <translation>Hrana nebo ústí, kde vstupuje voda.</translation>
    </message>
    <message>
        <source>Flow sink</source>
        <translation>Odtok</translation>
    </message>
    <message>
        <source>A plane or a box that takes flow out.</source>
        <translation>Rovina nebo kvádr, který tok odebírá.</translation>
    </message>
    <message>
        <source>Rigid body</source>
        <translation>Tuhé těleso</translation>
    </message>
    <message>
        <source>Makes a model solid for the flow.</source>
        <translation>Dělá z modelu pevnou překážku toku.</translation>
    </message>
    <message>
        <source>Newtonian</source>
        <translation>Newtonská</translation>
    </message>
    <message>
        <source>Power law</source>
        <translation>Mocninný zákon</translation>
    </message>
    <message>
        <source>Bingham</source>
        <translation>Binghamova</translation>
    </message>
    <message>
        <source>Herschel-Bulkley</source>
        <translation>Herschelova-Bulkleyho</translation>
    </message>
    <message>
        <source>Cross</source>
        <translation>Crossova</translation>
    </message>
    <message>
        <source>Frictional (Mohr-Coulomb)</source>
        <translation>Třecí (Mohr-Coulomb)</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>Zákon</translation>
    </message>
    <message>
        <source>How the viscosity follows from the shear rate. Snow is frictional: it piles up and stops.</source>
        <translation>Jak viskozita plyne z rychlosti smyku. Sníh je třecí: hromadí se a zastaví.</translation>
    </message>
    <message>
        <source>Density at rest.</source>
        <translation>Hustota v klidu.</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viskozita</translation>
    </message>
    <message>
        <source>Newtonian viscosity, consistency in Pa s^n, or that of a Cross fluid at rest.</source>
        <translation>Newtonská viskozita, konzistence v Pa s^n, nebo viskozita Crossovy kapaliny v klidu.</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>Exponent n of the power law, Herschel-Bulkley and Cross: below 1 the first two thin.</source>
        <translation>Exponent n mocninného zákona, Herschelova-Bulkleyho a Crossova: pod 1 první dva řídnou.</translation>
    </message>
    <message>
        <source>Cohesion</source>
        <translation>Soudržnost</translation>
    </message>
    <message>
        <source>Stress below which it does not flow without pressure: cohesion, or the yield stress.</source>
        <translation>Napětí, pod kterým bez tlaku neteče: soudržnost, nebo mez kluzu.</translation>
    </message>
    <message>
        <source>Friction angle</source>
        <translation>Úhel tření</translation>
    </message>
    <message>
        <source>Angle of internal friction; its tangent times the pressure adds to the cohesion.</source>
        <translation>Úhel vnitřního tření; jeho tangens krát tlak se přičítá k soudržnosti.</translation>
    </message>
    <message>
        <source>Viscosity at speed</source>
        <translation>Viskozita za pohybu</translation>
    </message>
    <message>
        <source>That of a Cross fluid in fast shear.</source>
        <translation>Viskozita Crossovy kapaliny v rychlém smyku.</translation>
    </message>
    <message>
        <source>Cross factor</source>
        <translation>Crossův součinitel</translation>
    </message>
    <message>
        <source>Cross&apos; K in s^n: how early it changes.</source>
        <translation>Crossovo K v s^n: jak brzy se mění.</translation>
    </message>
    <message>
        <source>Least viscosity</source>
        <translation>Nejmenší viskozita</translation>
    </message>
    <message>
        <source>The viscosity is held above this.</source>
        <translation>Viskozita se drží nad touto hodnotou.</translation>
    </message>
    <message>
        <source>Largest viscosity</source>
        <translation>Největší viskozita</translation>
    </message>
    <message>
        <source>The viscosity is held below this: larger values creep less at rest and ask for more steps.</source>
        <translation>Viskozita se drží pod touto hodnotou: větší hodnoty v klidu méně tečou a chtějí více kroků.</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Rychle</translation>
    </message>
    <message>
        <source>Accurate</source>
        <translation>Přesně</translation>
    </message>
    <message>
        <source>Summation</source>
        <translation>Součtem</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>Kontinuitou</translation>
    </message>
    <message>
        <source>Friction by coefficient</source>
        <translation>Tření podle součinitele</translation>
    </message>
    <message>
        <source>Sticks</source>
        <translation>Drží</translation>
    </message>
    <message>
        <source>Slides freely</source>
        <translation>Volně klouže</translation>
    </message>
    <message>
        <source>Friction coefficient of flow on this type of ground. Swiss guidelines give 0.155 to 0.35 for flowing snow (Salm, Burkard and Gubler 1990).</source>
        <translation>Součinitel tření toku na tomto druhu země. Švýcarské směrnice udávají pro tekoucí sníh 0,155 až 0,35 (Salm, Burkard a Gubler 1990).</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Rozestup</translation>
    </message>
    <message>
        <source>Distance of particles at rest. Half of it takes eight times the particles and sixteen times the work.</source>
        <translation>Vzdálenost částic v klidu. Polovina znamená osmkrát více částic a šestnáctkrát více práce.</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Přesnost</translation>
    </message>
    <message>
        <source>Particles act on others within 2 spacings (fast) or 3 (accurate, about three times the work).</source>
        <translation>Částice působí na jiné do 2 rozestupů (rychle) nebo 3 (přesně, asi trojnásobná práce).</translation>
    </message>
    <message>
        <source>Density by</source>
        <translation>Hustota podle</translation>
    </message>
    <message>
        <source>Summation over neighbours, or continuity with diffusion: quieter pressure, cheaper steps.</source>
        <translation>Součet přes sousedy, nebo kontinuita s difuzí: klidnější tlak, levnější kroky.</translation>
    </message>
    <message>
        <source>Sound speed</source>
        <translation>Rychlost zvuku</translation>
    </message>
    <message>
        <source>Stiffness of the flow: larger is less compressible and takes more steps; 0 finds it.</source>
        <translation>Tuhost toku: větší je méně stlačitelná a chce více kroků; 0 ji najde.</translation>
    </message>
    <message>
        <source>Longest step</source>
        <translation>Nejdelší krok</translation>
    </message>
    <message>
        <source>Time steps are never longer than this.</source>
        <translation>Časové kroky nejsou nikdy delší.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Vyhlazení</translation>
    </message>
    <message>
        <source>Share of the neighbours&apos; velocity that a particle takes on (XSPH).</source>
        <translation>Podíl rychlosti sousedů, který částice převezme (XSPH).</translation>
    </message>
    <message>
        <source>Viscosity cap</source>
        <translation>Mez viskozity</translation>
    </message>
    <message>
        <source>No viscosity is larger: less creep at rest asks for more steps; 0 finds one that leaves the step alone.</source>
        <translation>Žádná viskozita není větší: méně tečení v klidu chce více kroků; 0 najde mez, která krok nezkrátí.</translation>
    </message>
    <message>
        <source>Wind drag</source>
        <translation>Odpor větru</translation>
    </message>
    <message>
        <source>Acceleration by the wind per square of the speed against it.</source>
        <translation>Zrychlení větrem na čtverec rychlosti proti němu.</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Okraj</translation>
    </message>
    <message>
        <source>How far beyond the found reach of the flow the domain goes.</source>
        <translation>Jak daleko oblast sahá za nalezený dosah toku.</translation>
    </message>
    <message>
        <source>Headroom</source>
        <translation>Výška nad</translation>
    </message>
    <message>
        <source>How far the domain goes above ground and sources; what flies higher leaves.</source>
        <translation>Jak vysoko oblast sahá nad zem a zdroje; co letí výš, odchází.</translation>
    </message>
    <message>
        <source>Domain from</source>
        <translation>Oblast od</translation>
    </message>
    <message>
        <source>Lowest corner of the box that flow stays in; equal corners find the box from the terrain.</source>
        <translation>Nejnižší roh kvádru, ve kterém tok zůstává; stejné rohy najdou kvádr z terénu.</translation>
    </message>
    <message>
        <source>Domain to</source>
        <translation>Oblast do</translation>
    </message>
    <message>
        <source>Highest corner of the box that flow stays in.</source>
        <translation>Nejvyšší roh kvádru, ve kterém tok zůstává.</translation>
    </message>
    <message>
        <source>Closed domain</source>
        <translation>Uzavřená oblast</translation>
    </message>
    <message>
        <source>The sides of the domain are smooth walls; otherwise flow leaves there.</source>
        <translation>Strany oblasti jsou hladké stěny; jinak tam tok odchází.</translation>
    </message>
    <message>
        <source>Ground holds by</source>
        <translation>Země drží</translation>
    </message>
    <message>
        <source>How the ground holds what flows over it.</source>
        <translation>Jak země drží, co po ní teče.</translation>
    </message>
    <message>
        <source>Turbulent friction</source>
        <translation>Turbulentní tření</translation>
    </message>
    <message>
        <source>Voellmy&apos;s xi: the ground also holds by density times gravity times speed squared over xi; 0 is none. Published values are 400 to 4000 (Salm, Burkard and Gubler 1990).</source>
        <translation>Voellmyho xi: země drží také hustotou krát tíhovým zrychlením krát čtvercem rychlosti děleným xi; 0 je žádné. Publikované hodnoty jsou 400 až 4000 (Salm, Burkard a Gubler 1990).</translation>
    </message>
    <message>
        <source>Friction on quartz</source>
        <translation>Tření na křemeni</translation>
    </message>
    <message>
        <source>Friction on sand</source>
        <translation>Tření na písku</translation>
    </message>
    <message>
        <source>Friction on soil</source>
        <translation>Tření na půdě</translation>
    </message>
    <message>
        <source>Friction on vegetation</source>
        <translation>Tření na porostu</translation>
    </message>
    <message>
        <source>Friction on rock</source>
        <translation>Tření na skále</translation>
    </message>
    <message>
        <source>Friction on ice</source>
        <translation>Tření na ledu</translation>
    </message>
    <message>
        <source>Friction on asphalt</source>
        <translation>Tření na asfaltu</translation>
    </message>
    <message>
        <source>Friction on water</source>
        <translation>Tření na vodě</translation>
    </message>
    <message>
        <source>Flow material</source>
        <translation>Materiál toku</translation>
    </message>
    <message>
        <source>Numbers of a custom material that flows.</source>
        <translation>Čísla vlastního materiálu, který teče.</translation>
    </message>
    <message>
        <source>Flow settings</source>
        <translation>Nastavení toku</translation>
    </message>
    <message>
        <source>How avalanches and water are computed.</source>
        <translation>Jak se počítají laviny a voda.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Rychlost</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Tlak</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Zrychlení</translation>
    </message>
    <message>
        <source>Shear rate</source>
        <translation>Rychlost smyku</translation>
    </message>
    <message>
        <source>Particle class</source>
        <translation>Třída částic</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Stáří</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Sousedé</translation>
    </message>
    <message>
        <source>Within the flow</source>
        <translation>Uvnitř toku</translation>
    </message>
    <message>
        <source>Isolated</source>
        <translation>Osamocené</translation>
    </message>
    <message>
        <source>At the surface</source>
        <translation>Na povrchu</translation>
    </message>
    <message>
        <source>Flow shows</source>
        <translation>Tok ukazuje</translation>
    </message>
    <message>
        <source>What the colours of flowing particles tell. Material draws snow as snow and water as water.</source>
        <translation>Co říkají barvy tekoucích částic. Materiál kreslí sníh jako sníh a vodu jako vodu.</translation>
    </message>
    <message>
        <source>Range of the frame</source>
        <translation>Rozsah podle snímku</translation>
    </message>
    <message>
        <source>Spread the colours over what the frame&apos;s particles have; off takes the range below.</source>
        <translation>Rozprostře barvy na to, co mají částice snímku; vypnuto bere rozsah níže.</translation>
    </message>
    <message>
        <source>Range from</source>
        <translation>Rozsah od</translation>
    </message>
    <message>
        <source>Value of the darkest colour, in the unit that the legend shows.</source>
        <translation>Hodnota nejtmavší barvy v jednotce, kterou ukazuje legenda.</translation>
    </message>
    <message>
        <source>Range to</source>
        <translation>Rozsah do</translation>
    </message>
    <message>
        <source>Value of the brightest colour, in the unit that the legend shows.</source>
        <translation>Hodnota nejjasnější barvy v jednotce, kterou ukazuje legenda.</translation>
    </message>
    <message>
        <source>Logarithmic colours</source>
        <translation>Logaritmické barvy</translation>
    </message>
    <message>
        <source>Each step of colour multiplies the value: for viscosity and shear rate. Needs values above 0.</source>
        <translation>Každý stupeň barvy hodnotu násobí: pro viskozitu a rychlost smyku. Potřebuje hodnoty nad 0.</translation>
    </message>
    <message>
        <source>Show legend</source>
        <translation>Ukázat legendu</translation>
    </message>
    <message>
        <source>Show boundary particles</source>
        <translation>Ukázat hraniční částice</translation>
    </message>
    <message>
        <source>Draw the particles that stand for moving bodies.</source>
        <translation>Kreslit částice, které zastupují pohyblivá tělesa.</translation>
    </message>
    <message>
        <source>Pause snow</source>
        <translation>Pozastavit sníh</translation>
    </message>
    <message>
        <source>While it is on, falling snow and cover stand still and everything else goes on.</source>
        <translation>Dokud je zapnuto, sněžení a pokrývka stojí a vše ostatní běží dál.</translation>
    </message>
    <message>
        <source>Pause flow</source>
        <translation>Pozastavit tok</translation>
    </message>
    <message>
        <source>While it is on, avalanches, water and bodies stand still and everything else goes on.</source>
        <translation>Dokud je zapnuto, laviny, voda a tělesa stojí a vše ostatní běží dál.</translation>
    </message>
    <message>
        <source>State equation</source>
        <translation>Stavová rovnice</translation>
    </message>
    <message>
        <source>Solved for (DFSPH)</source>
        <translation>Řešený (DFSPH)</translation>
    </message>
    <message>
        <source>Pressure by</source>
        <translation>Tlak podle</translation>
    </message>
    <message>
        <source>The state equation (small, cheap steps, slightly compressible), or solved for so that the density stays: larger steps, each of many iterations.</source>
        <translation>Stavová rovnice (malé, levné kroky, mírná stlačitelnost), nebo řešený tak, aby hustota zůstala: větší kroky, každý z mnoha iterací.</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>Pevnost v tahu</translation>
    </message>
    <message>
        <source>Tension that it bears before it tears: what makes wet snow hang together and roll in lumps. Acts with the equation of state.</source>
        <translation>Tah, který snese, než se přetrhne: díky němu mokrý sníh drží pohromadě a valí se v hrudách. Působí se stavovou rovnicí.</translation>
    </message>
    <message>
        <source>Old snow</source>
        <translation>Starý sníh</translation>
    </message>
    <message>
        <source>Depth of the snow that lies on open level ground when the film begins. It fell with the wind of the first frame: steep slopes shed it, and sheltered places have less.</source>
        <translation>Výška sněhu, který na začátku filmu leží na otevřené vodorovné ploše. Napadl při větru prvního snímku: strmé svahy ho shazují a na chráněných místech ho je méně.</translation>
    </message>
    <message>
        <source>Density of old snow</source>
        <translation>Hustota starého sněhu</translation>
    </message>
    <message>
        <source>Density of the snow that lies when the film begins.</source>
        <translation>Hustota sněhu, který leží na začátku filmu.</translation>
    </message>
    <message>
        <source>Replaces old snow</source>
        <translation>Nahrazuje starý sníh</translation>
    </message>
    <message>
        <source>Lies on old snow</source>
        <translation>Leží na starém sněhu</translation>
    </message>
    <message>
        <source>Where painted</source>
        <translation>Kde je namalováno</translation>
    </message>
    <message>
        <source>Whether painted snow replaces the old snow of the snowfall or lies on top of it.</source>
        <translation>Zda malovaný sníh nahradí starý sníh ze sněžení, nebo leží na něm.</translation>
    </message>
    <message>
        <source>Density of the painted snow when the film begins.</source>
        <translation>Hustota namalovaného sněhu na začátku filmu.</translation>
    </message>
    <message>
        <source>GeoTIFF of the terrain&apos;s size with depths in m; written when the scene is saved.</source>
        <translation>GeoTIFF velikosti terénu s výškami sněhu v m; zapisuje se při uložení scény.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Síla</translation>
    </message>
    <message>
        <source>Factor on the painted share of the falling snow that is taken away.</source>
        <translation>Násobitel namalovaného podílu padajícího sněhu, který se odklízí.</translation>
    </message>
    <message>
        <source>Film time at which clearing begins.</source>
        <translation>Čas filmu, kdy odklízení začíná.</translation>
    </message>
    <message>
        <source>Film time at which clearing ends.</source>
        <translation>Čas filmu, kdy odklízení končí.</translation>
    </message>
    <message>
        <source>GeoTIFF of the terrain&apos;s size with shares from 0 to 1; written when the scene is saved.</source>
        <translation>GeoTIFF velikosti terénu s podíly od 0 do 1; zapisuje se při uložení scény.</translation>
    </message>
    <message>
        <source>Snow depth</source>
        <translation>Výška sněhu</translation>
    </message>
    <message>
        <source>Painted snow that lies when the film begins.</source>
        <translation>Malovaný sníh, který leží na začátku filmu.</translation>
    </message>
    <message>
        <source>Keep clear</source>
        <translation>Udržovat bez sněhu</translation>
    </message>
    <message>
        <source>Painted ground where falling snow is taken away: ploughed roads, heated yards.</source>
        <translation>Malovaná plocha, ze které se padající sníh odklízí: protažené silnice, vyhřívané dvory.</translation>
    </message>
    <message>
        <source>Ground type</source>
        <translation>Typ povrchu</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>Rozostření</translation>
    </message>
    <message>
        <source>Softens edges; what is not painted stays so.</source>
        <translation>Změkčí okraje; co není namalováno, zůstane tak.</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Medián</translation>
    </message>
    <message>
        <source>Takes specks away and keeps edges.</source>
        <translation>Odstraní tečky a zachová okraje.</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Rozšířit</translation>
    </message>
    <message>
        <source>High values and painted areas grow.</source>
        <translation>Vysoké hodnoty a namalované plochy se rozšíří.</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Zúžit</translation>
    </message>
    <message>
        <source>High values and painted areas shrink.</source>
        <translation>Vysoké hodnoty a namalované plochy se zúží.</translation>
    </message>
    <message>
        <source>Remove specks</source>
        <translation>Odstranit tečky</translation>
    </message>
    <message>
        <source>Shrinks, then grows: small areas vanish.</source>
        <translation>Zúží, pak rozšíří: malé plochy zmizí.</translation>
    </message>
    <message>
        <source>Fill gaps</source>
        <translation>Uzavřít mezery</translation>
    </message>
    <message>
        <source>Grows, then shrinks: small gaps close.</source>
        <translation>Rozšíří, pak zúží: malé mezery se uzavřou.</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Práh</translation>
    </message>
    <message>
        <source>Shares become all or nothing; of other layers what is less is taken away.</source>
        <translation>Podíly budou vše, nebo nic; z ostatních vrstev zmizí, co je menší.</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Obrátit</translation>
    </message>
    <message>
        <source>What was full becomes empty and the other way round.</source>
        <translation>Co bylo plné, bude prázdné a naopak.</translation>
    </message>
    <message>
        <source>Free cluster</source>
        <translation>Volný shluk</translation>
    </message>
    <message>
        <source>Six arms</source>
        <translation>Šest ramen</translation>
    </message>
    <message>
        <source>Eight arms</source>
        <translation>Osm ramen</translation>
    </message>
    <message>
        <source>Crystal</source>
        <translation>Krystal</translation>
    </message>
    <message>
        <source>Fern-like star</source>
        <translation>Hvězda podobná kapradí</translation>
    </message>
    <message>
        <source>Plain star</source>
        <translation>Prostá hvězda</translation>
    </message>
    <message>
        <source>Star with broad branches</source>
        <translation>Hvězda se širokými větvemi</translation>
    </message>
    <message>
        <source>Plate with corners</source>
        <translation>Destička s rohy</translation>
    </message>
    <message>
        <source>32 pixels</source>
        <translation>32 pixelů</translation>
    </message>
    <message>
        <source>64 pixels</source>
        <translation>64 pixelů</translation>
    </message>
    <message>
        <source>128 pixels</source>
        <translation>128 pixelů</translation>
    </message>
    <message>
        <source>256 pixels</source>
        <translation>256 pixelů</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Růst</translation>
    </message>
    <message>
        <source>Free cluster, six and eight arms grow by diffusion-limited aggregation, crystals by a lattice automaton.</source>
        <translation>Volný shluk, šest a osm ramen rostou difuzně omezenou agregací, krystaly mřížkovým automatem.</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Tvary</translation>
    </message>
    <message>
        <source>Number of different flakes that are grown.</source>
        <translation>Počet různých vloček, které vyrostou.</translation>
    </message>
    <message>
        <source>Another number grows other flakes of the same kind.</source>
        <translation>Jiné číslo dá vyrůst jiným vločkám téhož druhu.</translation>
    </message>
    <message>
        <source>Smallest radius</source>
        <translation>Nejmenší poloměr</translation>
    </message>
    <message>
        <source>Radius to which the smallest flake grows.</source>
        <translation>Poloměr, do něhož doroste nejmenší vločka.</translation>
    </message>
    <message>
        <source>Largest radius</source>
        <translation>Největší poloměr</translation>
    </message>
    <message>
        <source>Radius to which the largest flake grows.</source>
        <translation>Poloměr, do něhož doroste největší vločka.</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Podrobnost</translation>
    </message>
    <message>
        <source>Size of a flake&apos;s pictures; close-ups want fine ones.</source>
        <translation>Velikost obrázků vločky; záběry zblízka potřebují jemné.</translation>
    </message>
    <message>
        <source>Particle</source>
        <translation>Částice</translation>
    </message>
    <message>
        <source>Diameter of the particles that aggregate; the finer, the more branches. Not for crystals.</source>
        <translation>Průměr částic, které se shlukují; čím jemnější, tím více větví. Ne pro krystaly.</translation>
    </message>
    <message>
        <source>Most particles</source>
        <translation>Nejvíce částic</translation>
    </message>
    <message>
        <source>A flake that has as many stops growing. Not for crystals.</source>
        <translation>Vločka, která jich má tolik, přestane růst. Ne pro krystaly.</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Zarovnání</translation>
    </message>
    <message>
        <source>How far particles turn to the crystal&apos;s own directions: 0 gives corals, 1 branches at 60 degrees. For six and eight arms.</source>
        <translation>Jak dalece se částice natáčejí do vlastních směrů krystalu: 0 dává korály, 1 větve po 60 stupních. Pro šest a osm ramen.</translation>
    </message>
    <message>
        <source>Landings</source>
        <translation>Dopady</translation>
    </message>
    <message>
        <source>Particles that must land at a place before one stays: more give straighter arms. For six and eight arms.</source>
        <translation>Kolik částic musí na místo dopadnout, než jedna zůstane: více jich dává rovnější ramena. Pro šest a osm ramen.</translation>
    </message>
    <message>
        <source>Form of crystals</source>
        <translation>Tvar krystalů</translation>
    </message>
    <message>
        <source>Habit of the crystals that the automaton grows.</source>
        <translation>Habitus krystalů, které automat pěstuje.</translation>
    </message>
    <message>
        <source>Cells of crystals</source>
        <translation>Buňky krystalů</translation>
    </message>
    <message>
        <source>Lattice cells from the middle to the tips: more give finer branches, and take longer.</source>
        <translation>Buňky mřížky od středu ke špičkám: více jich dává jemnější větve a trvá déle.</translation>
    </message>
    <message>
        <source>Variety of crystals</source>
        <translation>Rozmanitost krystalů</translation>
    </message>
    <message>
        <source>How much the air changes while a crystal grows; it makes each one its own.</source>
        <translation>Jak moc se mění vzduch, zatímco krystal roste; díky tomu je každý svůj.</translation>
    </message>
    <message>
        <source>Flake shapes</source>
        <translation>Tvary vloček</translation>
    </message>
    <message>
        <source>Shapes of the falling flakes: what grows is what falls.</source>
        <translation>Tvary padajících vloček: co vyroste, to padá.</translation>
    </message>
    <message>
        <source>Drag and flutter</source>
        <translation>Odpor a třepotání</translation>
    </message>
    <message>
        <source>Decaying sine</source>
        <translation>Doznívající sinus</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Dráha</translation>
    </message>
    <message>
        <source>Drag and flutter: flakes follow the wind and swing steadily. Decaying sine: they fall at their terminal speed and swing in bursts that die away, wider and faster in wind.</source>
        <translation>Odpor a třepotání: vločky se řídí větrem a rovnoměrně se kývají. Doznívající sinus: padají mezní rychlostí a kývají se v návalech, které doznívají, ve větru šířeji a rychleji.</translation>
    </message>
    <message>
        <source>Gustiness</source>
        <translation>Nárazovitost</translation>
    </message>
    <message>
        <source>Strength of the gusts as a share of the mean wind: 0.1 over water, 0.2 in the open, 0.3 and more among houses and trees.</source>
        <translation>Síla nárazů jako podíl středního větru: 0,1 nad vodou, 0,2 v otevřené krajině, 0,3 a více mezi domy a stromy.</translation>
    </message>
    <message>
        <source>Size of gusts</source>
        <translation>Velikost nárazů</translation>
    </message>
    <message>
        <source>Wavelength of the largest eddies in the wind.</source>
        <translation>Vlnová délka největších vírů ve větru.</translation>
    </message>
    <message>
        <source>Edge of the box round the camera in which flakes are drawn; beyond it snow is haze.</source>
        <translation>Hrana krychle kolem kamery, v níž se kreslí vločky; za ní je sníh oparem.</translation>
    </message>
    <message>
        <source>Distance groups</source>
        <translation>Skupiny podle vzdálenosti</translation>
    </message>
    <message>
        <source>Shells round the camera: the farther one is, the fewer and larger its flakes, so that each hides as much of what is behind it as the precipitation asks for.</source>
        <translation>Slupky kolem kamery: čím je vzdálenější, tím má méně a větších vloček, takže každá zakrývá z toho, co je za ní, tolik, kolik srážky žádají.</translation>
    </message>
    <message>
        <source>Number of flakes in the box; each stands for as many real ones as the precipitation asks for. The more, the finer the snow.</source>
        <translation>Počet vloček v krychli; každá zastupuje tolik skutečných, kolik srážky žádají. Čím více, tím jemnější sníh.</translation>
    </message>
    <message>
        <source>Near size limit</source>
        <translation>Mez velikosti zblízka</translation>
    </message>
    <message>
        <source>Constant A of the size on screen, h S / sqrt(A + B D + C D^2), C being the lens: keeps near flakes small. 0 is perspective as it is.</source>
        <translation>Konstanta A velikosti na obrazovce, h S / sqrt(A + B D + C D^2), kde C je objektiv: drží blízké vločky malé. 0 je perspektiva, jaká je.</translation>
    </message>
    <message>
        <source>Size falloff</source>
        <translation>Úbytek velikosti</translation>
    </message>
    <message>
        <source>Linear term B of the size on screen: flakes shrink faster with the distance D at first. 0 is perspective as it is.</source>
        <translation>Lineární člen B velikosti na obrazovce: vločky se vzdáleností D zprvu zmenšují rychleji. 0 je perspektiva, jaká je.</translation>
    </message>
    <message>
        <source>Energy balance</source>
        <translation>Energetická bilance</translation>
    </message>
    <message>
        <source>Degree-day</source>
        <translation>Metoda stupeň-den</translation>
    </message>
    <message>
        <source>Tang and Zhang, as published</source>
        <translation>Tang a Zhang, jak publikovali</translation>
    </message>
    <message>
        <source>Lies as it fell</source>
        <translation>Leží, jak napadl</translation>
    </message>
    <message>
        <source>Melt</source>
        <translation>Tání</translation>
    </message>
    <message>
        <source>Energy balance: sun, sky, air, rain and ground, settling and refreezing. Degree-day: by the air&apos;s temperature alone. As published: the law of Tang and Zhang, for comparison; it knows no heat of melting. Lies as it fell: snow neither settles nor melts.</source>
        <translation>Energetická bilance: slunce, obloha, vzduch, déšť a země, sesedání a opětovné zamrzání. Metoda stupeň-den: pouze podle teploty vzduchu. Jak publikovali: zákon autorů Tang a Zhang pro srovnání; nezná skupenské teplo tání. Leží, jak napadl: sníh se nesesedá ani netaje.</translation>
    </message>
    <message>
        <source>Degree-day factor</source>
        <translation>Faktor stupeň-den</translation>
    </message>
    <message>
        <source>Water that melts per day and degree above the threshold; 2 to 6 are usual.</source>
        <translation>Voda, která odtaje za den na každý stupeň nad prahem; obvyklé je 2 až 6.</translation>
    </message>
    <message>
        <source>Degree-day threshold</source>
        <translation>Práh metody stupeň-den</translation>
    </message>
    <message>
        <source>Air temperature above which snow melts.</source>
        <translation>Teplota vzduchu, nad níž sníh taje.</translation>
    </message>
    <message>
        <source>Albedo of new snow</source>
        <translation>Albedo nového sněhu</translation>
    </message>
    <message>
        <source>Share of the sun&apos;s light that new snow sends back.</source>
        <translation>Podíl slunečního světla, který nový sníh odráží.</translation>
    </message>
    <message>
        <source>Albedo of old snow</source>
        <translation>Albedo starého sněhu</translation>
    </message>
    <message>
        <source>What the albedo of ageing snow falls to.</source>
        <translation>Na jakou hodnotu klesne albedo stárnoucího sněhu.</translation>
    </message>
    <message>
        <source>Height of the wind</source>
        <translation>Výška měření větru</translation>
    </message>
    <message>
        <source>Above ground, at which the wind is measured.</source>
        <translation>Výška nad zemí, v níž se měří vítr.</translation>
    </message>
    <message>
        <source>Height of the temperature</source>
        <translation>Výška měření teploty</translation>
    </message>
    <message>
        <source>Above ground, at which temperature and humidity are.</source>
        <translation>Výška nad zemí, pro niž platí teplota a vlhkost.</translation>
    </message>
    <message>
        <source>Slopes and shadow</source>
        <translation>Svahy a stín</translation>
    </message>
    <message>
        <source>Where a sun melts, it and the sky count by slope, aspect and horizon; off: everything lies level and open.</source>
        <translation>Kde slunce taví, počítá se s ním i s oblohou podle sklonu, orientace svahu a obzoru; vypnuto: vše leží vodorovně a otevřeně.</translation>
    </message>
    <message>
        <source>Horizon reach</source>
        <translation>Dosah obzoru</translation>
    </message>
    <message>
        <source>How far away mountains cast shadow.</source>
        <translation>Z jaké vzdálenosti ještě hory vrhají stín.</translation>
    </message>
    <message>
        <source>Place in local metres: east, north; it lies on the ground.</source>
        <translation>Místo v místních metrech: východ, sever; leží na zemi.</translation>
    </message>
    <message>
        <source>How far it warms; the heat fades towards the edge.</source>
        <translation>Jak daleko hřeje; k okraji teplo slábne.</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Výkon</translation>
    </message>
    <message>
        <source>Heat that goes into the ground at the centre; 100 W/m² melts 26 mm of water a day.</source>
        <translation>Teplo, které jde ve středu do země; 100 W/m² roztaví sníh o 26 mm vody za den.</translation>
    </message>
    <message>
        <source>Snow cover</source>
        <translation>Sněhová pokrývka</translation>
    </message>
    <message>
        <source>How lying snow settles, ages and melts.</source>
        <translation>Jak ležící sníh sesedá, stárne a taje.</translation>
    </message>
    <message>
        <source>Heat source</source>
        <translation>Zdroj tepla</translation>
    </message>
    <message>
        <source>Warm ground on which less snow stays.</source>
        <translation>Teplá země, na níž zůstává méně sněhu.</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Paprsky</translation>
    </message>
    <message>
        <source>Occlusion maps</source>
        <translation>Mapy zastínění</translation>
    </message>
    <message>
        <source>Shelter by</source>
        <translation>Závětří podle</translation>
    </message>
    <message>
        <source>Rays: exact but for the number of rays. Maps: pictures of the scene along a few directions of fall, quicker with many triangles and moving things, and a little coarse at edges.</source>
        <translation>Paprsky: přesné až na počet paprsků. Mapy: obrazy scény v několika směrech pádu, rychlejší při mnoha trojúhelnících a pohyblivých věcech a na okrajích trochu hrubé.</translation>
    </message>
    <message>
        <source>Map directions</source>
        <translation>Směry map</translation>
    </message>
    <message>
        <source>Directions of fall that maps are drawn for; few give stepped edges of shelter.</source>
        <translation>Směry pádu, pro které se mapy kreslí; při malém počtu má závětří stupňovité okraje.</translation>
    </message>
    <message>
        <source>Map size</source>
        <translation>Velikost mapy</translation>
    </message>
    <message>
        <source>Texels along a map at most; small ground takes as many as half a cell asks for.</source>
        <translation>Nejvyšší počet texelů na stranu mapy; malá plocha jich dostane tolik, aby jeden odpovídal polovině buňky.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Povrch</translation>
    </message>
    <message>
        <source>What the snow lies on: how well it conducts heat, how dark it is.</source>
        <translation>Na čem sníh leží: jak dobře povrch vede teplo a jak je tmavý.</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Teplo</translation>
    </message>
    <message>
        <source>Heat that comes up through the surface: 10 for a house, 100 melts 26 mm of water a day.</source>
        <translation>Teplo, které prostupuje povrchem vzhůru: 10 pro dům, 100 roztaví sníh o 26 mm vody za den.</translation>
    </message>
    <message>
        <source>Dusting</source>
        <translation>Poprašek</translation>
    </message>
    <message>
        <source>In pictures, how much of the snow of the ground beside it shows on what faces up: for trees and small things in great numbers that catch no snow of their own.</source>
        <translation>Jaká část sněhu z okolní země se v obrazech ukáže na plochách obrácených vzhůru: pro stromy a drobné věci ve velkém počtu, které samy sníh nezachytávají.</translation>
    </message>
    <message>
        <source>Fine cover round it</source>
        <translation>Jemná pokrývka kolem</translation>
    </message>
    <message>
        <source>The ground round the model has small cover cells, so that lee and eaves show; off for what stands far away or in great numbers.</source>
        <translation>Země kolem modelu má malé buňky pokrývky, aby bylo vidět závětří a přesahy střech; vypněte u toho, co stojí daleko nebo ve velkém počtu.</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Kopie</translation>
    </message>
    <message>
        <source>Places (east, north) at which the model stands once more.</source>
        <translation>Místa (východ, sever), na nichž model stojí ještě jednou.</translation>
    </message>
    <message>
        <source>Turn of copies</source>
        <translation>Otočení kopií</translation>
    </message>
    <message>
        <source>Range within which copies are turned at random.</source>
        <translation>Rozsah, v němž se kopie náhodně otáčejí.</translation>
    </message>
    <message>
        <source>Size of copies</source>
        <translation>Velikost kopií</translation>
    </message>
    <message>
        <source>Share by which copies are larger or smaller at random: 0.2 gives 0.8 to 1.2.</source>
        <translation>Podíl, o který jsou kopie náhodně větší nebo menší: 0,2 dává 0,8 až 1,2.</translation>
    </message>
    <message>
        <source>Seed of copies</source>
        <translation>Semínko kopií</translation>
    </message>
    <message>
        <source>Another number turns and scales the copies otherwise.</source>
        <translation>Jiné číslo otočí a zvětší či zmenší kopie jinak.</translation>
    </message>
    <message>
        <source>Always snow</source>
        <translation>Vždy sníh</translation>
    </message>
    <message>
        <source>Snow or rain by temperature</source>
        <translation>Sníh nebo déšť podle teploty</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Žádné</translation>
    </message>
    <message>
        <source>As in pictures</source>
        <translation>Jako na obrazech</translation>
    </message>
    <message>
        <source>By date</source>
        <translation>Podle data</translation>
    </message>
    <message>
        <source>Falls as</source>
        <translation>Padá jako</translation>
    </message>
    <message>
        <source>Snow whatever the air&apos;s temperature, or at every place what its air and humidity make of it.</source>
        <translation>Sníh při jakékoli teplotě vzduchu, nebo na každém místě to, co z něj udělá teplota a vlhkost tamního vzduchu.</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Vlhkost</translation>
    </message>
    <message>
        <source>Relative humidity of the air; dry air lets snow vanish without melting.</source>
        <translation>Relativní vlhkost vzduchu; v suchém vzduchu sníh mizí, aniž taje.</translation>
    </message>
    <message>
        <source>Station record</source>
        <translation>Záznam stanice</translation>
    </message>
    <message>
        <source>Text file of a weather station, a row per step: year, month, day, hour (UTC), shortwave and longwave W/m2, snowfall and rainfall kg/(m2 s), air temperature K, humidity %, wind m/s, pressure Pa. It replaces the values above but the wind&apos;s direction and the speed that tilts the fall.</source>
        <translation>Textový soubor meteorologické stanice, řádek na krok: rok, měsíc, den, hodina (UTC), krátkovlnné a dlouhovlnné záření W/m2, sněhové a dešťové srážky kg/(m2 s), teplota vzduchu K, vlhkost %, vítr m/s, tlak Pa. Nahrazuje hodnoty výše kromě směru větru a rychlosti, která sklání pád sněhu.</translation>
    </message>
    <message>
        <source>Film begins</source>
        <translation>Začátek filmu</translation>
    </message>
    <message>
        <source>Date and time (UTC) at which the film begins, as 2005-10-01 00:00. Empty: at the begin of the station record.</source>
        <translation>Datum a čas (UTC), kdy film začíná, ve tvaru 2005-10-01 00:00. Prázdné: na začátku záznamu stanice.</translation>
    </message>
    <message>
        <source>Sun that melts</source>
        <translation>Slunce pro tání</translation>
    </message>
    <message>
        <source>None: as at night or under the thickest cloud. As in pictures: the sun that azimuth and elevation set. By date: where date and place put it, with day, season and the shadow of mountains.</source>
        <translation>Žádné: jako v noci nebo pod nejhustšími oblaky. Jako na obrazech: slunce, které určuje azimut a výška. Podle data: tam, kam je klade datum a místo, s dnem, ročním obdobím a stínem hor.</translation>
    </message>
    <message>
        <source>Sun of the date lights</source>
        <translation>Svítí slunce podle data</translation>
    </message>
    <message>
        <source>Pictures have the sun of date and place, nights too; off: azimuth and elevation.</source>
        <translation>Obrazy mají slunce podle data a místa, i noci; vypnuto: azimut a výška.</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Zeměpisná šířka</translation>
    </message>
    <message>
        <source>Of the scene, north positive; for the sun.</source>
        <translation>Šířka scény, na sever kladná; pro slunce.</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Zeměpisná délka</translation>
    </message>
    <message>
        <source>Of the scene, east positive; for the sun.</source>
        <translation>Délka scény, na východ kladná; pro slunce.</translation>
    </message>
    <message>
        <source>Weather of an altitude</source>
        <translation>Počasí nadmořské výšky</translation>
    </message>
    <message>
        <source>The weather was measured at the altitude below; off: at the terrain&apos;s lowest point.</source>
        <translation>Počasí bylo měřeno v nadmořské výšce uvedené níže; vypnuto: v nejnižším bodě terénu.</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Nadmořská výška</translation>
    </message>
    <message>
        <source>Height above sea level at which the weather was measured.</source>
        <translation>Výška nad hladinou moře, v níž bylo počasí měřeno.</translation>
    </message>
    <message>
        <source>Cooling upwards</source>
        <translation>Ochlazování s výškou</translation>
    </message>
    <message>
        <source>How much colder the air is higher up; 6.5 K/km is usual, 0 gives one temperature.</source>
        <translation>O kolik je vzduch výše chladnější; obvyklé je 6,5 K/km, 0 dává jednu teplotu.</translation>
    </message>
    <message>
        <source>More precipitation upwards</source>
        <translation>Přibývání srážek s výškou</translation>
    </message>
    <message>
        <source>How much more falls higher up, as a share of what falls where the weather was measured.</source>
        <translation>O kolik více padá výše, jako podíl toho, co padá v místě měření počasí.</translation>
    </message>
    <message>
        <source>Snow slides</source>
        <translation>Sníh sjíždí</translation>
    </message>
    <message>
        <source>Snow that lies steeper than its angle of repose moves down, off roofs too.</source>
        <translation>Sníh, který leží strměji, než je jeho sypný úhel, sjede dolů, i ze střech.</translation>
    </message>
    <message>
        <source>Repose of dry snow</source>
        <translation>Sypný úhel suchého sněhu</translation>
    </message>
    <message>
        <source>Steepest slope that loose dry snow keeps.</source>
        <translation>Nejstrmější svah, na kterém se sypký suchý sníh udrží.</translation>
    </message>
    <message>
        <source>Repose of slush</source>
        <translation>Sypný úhel břečky</translation>
    </message>
    <message>
        <source>Steepest slope that snow with 15 % of liquid water by volume keeps; moist snow with less than 3 % keeps what dry snow does.</source>
        <translation>Nejstrmější svah, na kterém se udrží sníh s 15 % objemu kapalné vody; vlhký sníh s méně než 3 % drží stejně jako suchý.</translation>
    </message>
    <message>
        <source>Width of hollows in the snow&apos;s surface that fill within a day; 0 keeps them.</source>
        <translation>Šířka prohlubní v povrchu sněhu, které se během dne vyplní; 0 je ponechá.</translation>
    </message>
    <message>
        <source>Snow drifts</source>
        <translation>Vítr přenáší sníh</translation>
    </message>
    <message>
        <source>The wind carries snow along the ground: it takes it up where it speeds up and lays it down in the lee.</source>
        <translation>Vítr nese sníh při zemi: bere ho tam, kde zrychluje, a ukládá ho v závětří.</translation>
    </message>
    <message>
        <source>Drifts from</source>
        <translation>Přenáší od</translation>
    </message>
    <message>
        <source>Wind 10 m above ground from which snow drifts. 0 takes it from air temperature, wetness and density.</source>
        <translation>Vítr 10 m nad zemí, od kterého se sníh přenáší. 0 jej určí z teploty vzduchu, vlhkosti a hustoty sněhu.</translation>
    </message>
    <message>
        <source>Drift over the border</source>
        <translation>Přenos přes okraj</translation>
    </message>
    <message>
        <source>Share of what the wind can carry that blows in over the scene&apos;s windward border: 1 where the snow goes on beyond it, 0 where nothing comes.</source>
        <translation>Podíl toho, co vítr unese, který přivane přes návětrný okraj scény: 1, kde sníh pokračuje i za ním, 0, kde nic nepřichází.</translation>
    </message>
    <message>
        <source>Natural colours</source>
        <translation>Přirozené barvy</translation>
    </message>
    <message>
        <source>Snow water equivalent</source>
        <translation>Vodní hodnota sněhu</translation>
    </message>
    <message>
        <source>Snow density</source>
        <translation>Hustota sněhu</translation>
    </message>
    <message>
        <source>Surface temperature</source>
        <translation>Teplota povrchu</translation>
    </message>
    <message>
        <source>Liquid water in the snow</source>
        <translation>Kapalná voda ve sněhu</translation>
    </message>
    <message>
        <source>Exposure to snowfall</source>
        <translation>Vystavení sněžení</translation>
    </message>
    <message>
        <source>Physically based</source>
        <translation>Fyzikálně založené</translation>
    </message>
    <message>
        <source>Blinn-Phong, as published</source>
        <translation>Blinn-Phong, jak byl zveřejněn</translation>
    </message>
    <message>
        <source>Snow shows</source>
        <translation>Sníh ukazuje</translation>
    </message>
    <message>
        <source>What the colours of the snow cover tell, on the ground and on models. Natural colours draw it as snow; ground that has no value is grey.</source>
        <translation>Co říkají barvy sněhové pokrývky na zemi a na modelech. Přirozené barvy ji kreslí jako sníh; místa bez hodnoty jsou šedá.</translation>
    </message>
    <message>
        <source>Range of the frame&apos;s snow</source>
        <translation>Rozsah podle sněhu snímku</translation>
    </message>
    <message>
        <source>Spread the colours over what the frame&apos;s cover has; off takes the range below, the same for all frames.</source>
        <translation>Rozloží barvy na hodnoty, které má pokrývka snímku; vypnuto použije níže zadaný rozsah, stejný pro všechny snímky.</translation>
    </message>
    <message>
        <source>Snow range from</source>
        <translation>Rozsah sněhu od</translation>
    </message>
    <message>
        <source>Snow range to</source>
        <translation>Rozsah sněhu do</translation>
    </message>
    <message>
        <source>Snow shading</source>
        <translation>Osvětlení sněhu</translation>
    </message>
    <message>
        <source>Physically based snow scatters light below its surface and is bluish in the shade. The published model adds ambient, diffuse and mirrored light, and mixes snow with what lies below by the exposure.</source>
        <translation>Fyzikálně založený sníh rozptyluje světlo pod povrchem a ve stínu je namodralý. Zveřejněný model sčítá okolní, rozptýlené a zrcadlené světlo a míchá sníh s tím, co je pod ním, podle vystavení.</translation>
    </message>
    <message>
        <source>Ambient reflection</source>
        <translation>Odraz okolního světla</translation>
    </message>
    <message>
        <source>K_a of the published shading: share of the sky&apos;s light that snow reflects.</source>
        <translation>K_a zveřejněného osvětlení: podíl světla oblohy, který sníh odráží.</translation>
    </message>
    <message>
        <source>Diffuse reflection</source>
        <translation>Rozptýlený odraz</translation>
    </message>
    <message>
        <source>K_d of the published shading: share of the sun&apos;s light that snow reflects to all sides.</source>
        <translation>K_d zveřejněného osvětlení: podíl slunečního světla, který sníh odráží do všech stran.</translation>
    </message>
    <message>
        <source>Mirror reflection</source>
        <translation>Zrcadlový odraz</translation>
    </message>
    <message>
        <source>K_s of the published shading: share of the sun&apos;s light in the highlight.</source>
        <translation>K_s zveřejněného osvětlení: podíl slunečního světla v odlesku.</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>Lesklost</translation>
    </message>
    <message>
        <source>n of the published shading: the higher, the smaller the highlight.</source>
        <translation>n zveřejněného osvětlení: čím vyšší, tím menší odlesk.</translation>
    </message>
    <message>
        <source>Mist and powder, OpenVDB</source>
        <translation>Mlha a sněhový prach, OpenVDB</translation>
    </message>
    <message>
        <source>Mist density</source>
        <translation>Hustota mlhy</translation>
    </message>
    <message>
        <source>Mist velocity</source>
        <translation>Rychlost mlhy</translation>
    </message>
    <message>
        <source>Excess temperature</source>
        <translation>Teplotní rozdíl proti okolí</translation>
    </message>
    <message>
        <source>Divergence</source>
        <translation>Divergence</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Vypnuto</translation>
    </message>
    <message>
        <source>Across x</source>
        <translation>Kolmo k x</translation>
    </message>
    <message>
        <source>Across y</source>
        <translation>Kolmo k y</translation>
    </message>
    <message>
        <source>Across z</source>
        <translation>Kolmo k z</translation>
    </message>
    <message>
        <source>Print what the colours of flow, snow and air mean where they stand for values.</source>
        <translation>Vytiskne, co znamenají barvy proudu, sněhu a vzduchu tam, kde vyjadřují hodnoty.</translation>
    </message>
    <message>
        <source>Air shows</source>
        <translation>Vzduch ukazuje</translation>
    </message>
    <message>
        <source>What the colours of mist and powder in the air tell: mass per volume, speed, how much warmer than the air around, or what the pressure solver left of the divergence. Natural colours draw them as they look.</source>
        <translation>Co říkají barvy mlhy a sněhového prachu ve vzduchu: hmotnost v objemu, rychlost, oč jsou teplejší než okolní vzduch, nebo co z divergence nechal řešič tlaku. Přirozené barvy je kreslí tak, jak vypadají.</translation>
    </message>
    <message>
        <source>Air slice</source>
        <translation>Řez vzduchem</translation>
    </message>
    <message>
        <source>Show the values of the air on a plane across this axis instead of in the whole cloud. Needs a value to show.</source>
        <translation>Ukáže hodnoty vzduchu na rovině kolmé k této ose místo v celém oblaku. Vyžaduje zvolenou hodnotu.</translation>
    </message>
    <message>
        <source>Slice at</source>
        <translation>Poloha řezu</translation>
    </message>
    <message>
        <source>Where the plane stands on its axis.</source>
        <translation>Kde na své ose rovina stojí.</translation>
    </message>
    <message>
        <source>Range of the frame&apos;s air</source>
        <translation>Rozsah podle vzduchu snímku</translation>
    </message>
    <message>
        <source>Spread the colours over what the frame&apos;s air has; off takes the range below, the same for all frames.</source>
        <translation>Rozloží barvy na hodnoty, které má vzduch snímku; vypnuto použije níže zadaný rozsah, stejný pro všechny snímky.</translation>
    </message>
    <message>
        <source>Air range from</source>
        <translation>Rozsah vzduchu od</translation>
    </message>
    <message>
        <source>Air range to</source>
        <translation>Rozsah vzduchu do</translation>
    </message>
    <message>
        <source>Semi-Lagrangian</source>
        <translation>Semi-lagrangeovská</translation>
    </message>
    <message>
        <source>MacCormack</source>
        <translation>MacCormackova</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Kubická</translation>
    </message>
    <message>
        <source>Conjugate gradients with multigrid</source>
        <translation>Sdružené gradienty s multigridem</translation>
    </message>
    <message>
        <source>Jacobi sweeps</source>
        <translation>Jacobiho iterace</translation>
    </message>
    <message>
        <source>Gauss-Seidel sweeps</source>
        <translation>Gaussovy-Seidelovy iterace</translation>
    </message>
    <message>
        <source>Density of humid air and its load</source>
        <translation>Hustota vlhkého vzduchu s jeho nákladem</translation>
    </message>
    <message>
        <source>Difference of stacked cells</source>
        <translation>Rozdíl buněk nad sebou</translation>
    </message>
    <message>
        <source>Fog density</source>
        <translation>Hustota mlhy</translation>
    </message>
    <message>
        <source>Edge of the air&apos;s cells; 0 takes four spacings of the flow. Half of it takes eight times the cells.</source>
        <translation>Hrana buněk vzduchu; 0 znamená čtyři rozestupy částic proudu. Poloviční hrana znamená osmkrát více buněk.</translation>
    </message>
    <message>
        <source>Exchange every</source>
        <translation>Výměna po</translation>
    </message>
    <message>
        <source>Longest film time from one exchange between flow and air to the next; longer frames are cut.</source>
        <translation>Nejdelší filmový čas mezi dvěma výměnami proudu se vzduchem; delší snímky se rozdělí.</translation>
    </message>
    <message>
        <source>Advection</source>
        <translation>Advekce</translation>
    </message>
    <message>
        <source>How the wind of the cloud is carried along: semi-Lagrangian as published, or one of two sharper schemes.</source>
        <translation>Jak se přenáší proudění v oblaku: semi-lagrangeovsky, jak bylo publikováno, nebo jedním ze dvou ostřejších schémat.</translation>
    </message>
    <message>
        <source>Reflection</source>
        <translation>Odraz</translation>
    </message>
    <message>
        <source>Two projections a step keep eddies alive that one would damp.</source>
        <translation>Dvě projekce v kroku udrží víry, které by jedna utlumila.</translation>
    </message>
    <message>
        <source>Pressure solver</source>
        <translation>Řešič tlaku</translation>
    </message>
    <message>
        <source>How the pressure is found: to the tolerance, or by a fixed number of sweeps as published.</source>
        <translation>Jak se hledá tlak: na zadanou přesnost, nebo pevným počtem iterací, jak bylo publikováno.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerance</translation>
    </message>
    <message>
        <source>Residual of the pressure over its right side, at most.</source>
        <translation>Největší reziduum tlaku vztažené k pravé straně.</translation>
    </message>
    <message>
        <source>Lift by</source>
        <translation>Vztlak podle</translation>
    </message>
    <message>
        <source>What makes the cloud rise or sink: the density of humid air with its load, or one of two published forms.</source>
        <translation>Co oblak zvedá nebo táhne dolů: hustota vlhkého vzduchu s jeho nákladem, nebo jedna ze dvou publikovaných podob.</translation>
    </message>
    <message>
        <source>How far the air reaches beyond the sides of the flow&apos;s box.</source>
        <translation>Jak daleko sahá vzduch za boky oblasti proudu.</translation>
    </message>
    <message>
        <source>How far the air reaches above the flow&apos;s box; what rises higher leaves.</source>
        <translation>Jak vysoko sahá vzduch nad oblast proudu; co vystoupá výš, odejde.</translation>
    </message>
    <message>
        <source>Eddy viscosity</source>
        <translation>Vírová viskozita</translation>
    </message>
    <message>
        <source>Mist evaporates</source>
        <translation>Mlha se vypařuje</translation>
    </message>
    <message>
        <source>Mist and vapour seek saturation: mist thins out in dry air and forms where moist air cools.</source>
        <translation>Mlha a pára směřují k nasycení: v suchém vzduchu mlha řídne a vzniká tam, kde vlhký vzduch chladne.</translation>
    </message>
    <message>
        <source>Mist droplets</source>
        <translation>Kapičky mlhy</translation>
    </message>
    <message>
        <source>Diameter of the droplets of mist: they sink and scatter light by it.</source>
        <translation>Průměr kapiček mlhy: podle něj klesají a rozptylují světlo.</translation>
    </message>
    <message>
        <source>Powder grains</source>
        <translation>Zrna prachu</translation>
    </message>
    <message>
        <source>Diameter of the grains of powder snow.</source>
        <translation>Průměr zrn prachového sněhu.</translation>
    </message>
    <message>
        <source>Water temperature</source>
        <translation>Teplota vody</translation>
    </message>
    <message>
        <source>Temperature of all water that flows: warmer than the air its mist rises, colder it hugs the ground.</source>
        <translation>Teplota veškeré tekoucí vody: je-li teplejší než vzduch, mlha stoupá, je-li chladnější, drží se při zemi.</translation>
    </message>
    <message>
        <source>Water warms air</source>
        <translation>Voda ohřívá vzduch</translation>
    </message>
    <message>
        <source>The surface of water and its drops give heat and vapour to the air that passes, or take them.</source>
        <translation>Hladina vody a její kapky předávají okolnímu vzduchu teplo a páru, nebo je z něj berou.</translation>
    </message>
    <message>
        <source>Impact from</source>
        <translation>Náraz od</translation>
    </message>
    <message>
        <source>Acceleration from which a particle counts as hitting something.</source>
        <translation>Zrychlení, od kterého se bere, že částice do něčeho narazila.</translation>
    </message>
    <message>
        <source>Mist by impact</source>
        <translation>Mlha nárazem</translation>
    </message>
    <message>
        <source>Share of water that an impact turns to mist per metre a second of speed that it takes.</source>
        <translation>Podíl vody, který náraz promění v mlhu na každý metr za sekundu ztracené rychlosti.</translation>
    </message>
    <message>
        <source>Powder by impact</source>
        <translation>Prach nárazem</translation>
    </message>
    <message>
        <source>Share of snow that an impact turns to powder per metre a second of speed that it takes.</source>
        <translation>Podíl sněhu, který náraz promění v prach na každý metr za sekundu ztracené rychlosti.</translation>
    </message>
    <message>
        <source>Mist from</source>
        <translation>Mlha od</translation>
    </message>
    <message>
        <source>Mist rate</source>
        <translation>Rychlost tvorby mlhy</translation>
    </message>
    <message>
        <source>Share of the particles at the surface of water that turns to mist a second, at three times that speed.</source>
        <translation>Podíl částic na povrchu vody, který se za sekundu promění v mlhu při trojnásobku té rychlosti.</translation>
    </message>
    <message>
        <source>Powder from</source>
        <translation>Prach od</translation>
    </message>
    <message>
        <source>Powder rate</source>
        <translation>Rychlost tvorby prachu</translation>
    </message>
    <message>
        <source>Share of the particles at the surface of snow that turns to powder a second, at three times that speed.</source>
        <translation>Podíl částic na povrchu sněhu, který se za sekundu promění v prach při trojnásobku té rychlosti.</translation>
    </message>
    <message>
        <source>Most given</source>
        <translation>Nejvíce odevzdáno</translation>
    </message>
    <message>
        <source>Share of its mass that a particle in the flow gives to the air at most.</source>
        <translation>Největší podíl hmotnosti, který částice v proudu odevzdá vzduchu.</translation>
    </message>
    <message>
        <source>Spray</source>
        <translation>Tříšť</translation>
    </message>
    <message>
        <source>Particles that are alone leave the flow and fly on as drops.</source>
        <translation>Osamělé částice opouštějí proud a letí dál jako kapky.</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Kapky</translation>
    </message>
    <message>
        <source>Diameter of the largest drops of spray; the air tears them to smaller ones where they are fast.</source>
        <translation>Průměr největších kapek tříště; rychlé kapky vzduch roztrhá na menší.</translation>
    </message>
    <message>
        <source>Snow clumps</source>
        <translation>Hroudy sněhu</translation>
    </message>
    <message>
        <source>Diameter of the clumps of snow that fly on their own.</source>
        <translation>Průměr hrud sněhu, které letí samostatně.</translation>
    </message>
    <message>
        <source>Life of spray</source>
        <translation>Životnost tříště</translation>
    </message>
    <message>
        <source>Spray rate</source>
        <translation>Rychlost tvorby tříště</translation>
    </message>
    <message>
        <source>Share of a particle at the surface of water that is thrown up a second where air is trapped, a crest breaks and energy is high.</source>
        <translation>Podíl částice na povrchu vody, který je za sekundu vymrštěn tam, kde se zachytává vzduch, láme se hřeben a je mnoho energie.</translation>
    </message>
    <message>
        <source>Trapped air from</source>
        <translation>Zachycený vzduch od</translation>
    </message>
    <message>
        <source>Mean speed at which neighbours come nearer from which air is trapped (Ihmsen et al. 2012).</source>
        <translation>Střední rychlost přibližování sousedů, od které se zachytává vzduch (Ihmsen a kol. 2012).</translation>
    </message>
    <message>
        <source>Trapped air up to</source>
        <translation>Zachycený vzduch do</translation>
    </message>
    <message>
        <source>The same, beyond which no more is thrown up.</source>
        <translation>Totéž; nad touto hodnotou se už nevymršťuje více.</translation>
    </message>
    <message>
        <source>Crests from</source>
        <translation>Hřebeny od</translation>
    </message>
    <message>
        <source>Bend of the surface from which a wave&apos;s crest breaks (Ihmsen et al. 2012): mean of 1 - cosine of the angle between normals.</source>
        <translation>Zakřivení povrchu, od kterého se hřeben vlny láme (Ihmsen a kol. 2012): průměr 1 - kosinus úhlu mezi normálami.</translation>
    </message>
    <message>
        <source>Crests up to</source>
        <translation>Hřebeny do</translation>
    </message>
    <message>
        <source>Energy from</source>
        <translation>Energie od</translation>
    </message>
    <message>
        <source>Kinetic energy per kilogram from which water is thrown up (Ihmsen et al. 2012).</source>
        <translation>Kinetická energie na kilogram, od které se voda vymršťuje (Ihmsen a kol. 2012).</translation>
    </message>
    <message>
        <source>Energy up to</source>
        <translation>Energie do</translation>
    </message>
    <message>
        <source>Most spray</source>
        <translation>Nejvíce tříště</translation>
    </message>
    <message>
        <source>Parcels of spray at most; beyond, what is alone stays in the flow and nothing is thrown up.</source>
        <translation>Největší počet balíků tříště; nad ním zůstává osamělé v proudu a nic se nevymršťuje.</translation>
    </message>
    <message>
        <source>Mist and powder</source>
        <translation>Mlha a sněhový prach</translation>
    </message>
    <message>
        <source>What hangs in the air over water and avalanches, and how it is computed.</source>
        <translation>Co visí ve vzduchu nad vodou a lavinami a jak se to počítá.</translation>
    </message>
    <message>
        <source>Pause mist and powder</source>
        <translation>Pozastavit mlhu a prach</translation>
    </message>
    <message>
        <source>While it is on, mist, powder and spray stand still and everything else goes on.</source>
        <translation>Dokud je zapnuto, mlha, prach a tříšť stojí a vše ostatní pokračuje.</translation>
    </message>
    <message>
        <source>Speed against the air from which the surface of water frays and impacts throw up mist; all of it at three times that speed.</source>
        <translation>Rychlost vůči vzduchu, od které se povrch vody třepí a nárazy vrhají mlhu; naplno při jejím trojnásobku.</translation>
    </message>
    <message>
        <source>Speed against the air from which the surface of snow is whirled up and impacts throw up powder; all of it at three times that speed.</source>
        <translation>Rychlost vůči vzduchu, od které se povrch sněhu víří a nárazy vrhají prach; naplno při jejím trojnásobku.</translation>
    </message>
    <message>
        <source>Small eddies</source>
        <translation>Malé víry</translation>
    </message>
    <message>
        <source>Mixing by eddies that are smaller than a cell, by how fast the air shears: Smagorinsky&apos;s constant, 0.1 to 0.2; 0 leaves it out.</source>
        <translation>Promíchávání víry menšími než buňka podle toho, jak rychle se vzduch střihá: Smagorinského konstanta, 0,1 až 0,2; 0 ho vynechá.</translation>
    </message>
    <message>
        <source>The same mixing everywhere, whatever the air does.</source>
        <translation>Totéž promíchávání všude, ať vzduch dělá cokoli.</translation>
    </message>
    <message>
        <source>Lumps</source>
        <translation>Shluky vody</translation>
    </message>
    <message>
        <source>Diameter of the lumps of water that leave the flow, if that is less than its spacing; the air tears them to drops.</source>
        <translation>Průměr shluků vody, které opouštějí proud, je-li menší než jeho rozestup; vzduch je trhá na kapky.</translation>
    </message>
    <message>
        <source>Time in which flying drops fray into mist, to 37 %; larger ones take longer.</source>
        <translation>Doba, za kterou se letící kapky rozpadnou na mlhu až na 37 %; větším to trvá déle.</translation>
    </message>
    <message>
        <source>Life of clumps</source>
        <translation>Život hrud</translation>
    </message>
    <message>
        <source>Time in which flying clumps of snow fray into powder, to 37 %.</source>
        <translation>Doba, za kterou se letící hroudy sněhu rozpadnou na prach až na 37 %.</translation>
    </message>
</context>
<context>
    <name>SceneChecks</name>
    <message>
        <source>Camera and target stand on the same spot. Move one of them.</source>
        <translation>Kamera a cíl stojí na stejném místě. Posuňte jedno z nich.</translation>
    </message>
    <message>
        <source>There is no camera: pictures use a default view. Add a camera.</source>
        <translation>Chybí kamera: obrazy použijí výchozí pohled. Přidejte kameru.</translation>
    </message>
    <message>
        <source>It snows without weather: default weather is used. Add weather.</source>
        <translation>Sněží bez počasí: použije se výchozí počasí. Přidejte počasí.</translation>
    </message>
    <message>
        <source>The last frame comes before the first one.</source>
        <translation>Poslední snímek předchází prvnímu.</translation>
    </message>
    <message>
        <source>Slopes must shed their snow at a steeper angle than they hold it.</source>
        <translation>Svahy musí sníh shazovat při strmějším úhlu, než při jakém jej drží.</translation>
    </message>
    <message>
        <source>Samples per pixel should be 1, 2, 4 or 8.</source>
        <translation>Počet vzorků na pixel má být 1, 2, 4 nebo 8.</translation>
    </message>
    <message>
        <source>The file %1 lies outside the scene&apos;s folder: the command line refuses it, and it is missing where the scene is moved to. Use File &gt; Collect files beside the scene.</source>
        <translation>Soubor %1 leží mimo složku scény: příkazový řádek ho odmítne a po přesunutí scény bude chybět. Použijte Soubor &gt; Sebrat soubory ke scéně.</translation>
    </message>
    <message>
        <source>No file is chosen for %1.</source>
        <translation>Pro %1 není vybrán soubor.</translation>
    </message>
    <message>
        <source>The film&apos;s begin is no date. Write it as 2005-10-01 00:00 (UTC).</source>
        <translation>Začátek filmu není datum. Zapište jej jako 2005-10-01 00:00 (UTC).</translation>
    </message>
    <message>
        <source>The sun needs a date: it stands still until the film&apos;s begin is set.</source>
        <translation>Slunce potřebuje datum: stojí, dokud není nastaven začátek filmu.</translation>
    </message>
    <message>
        <source>What flows passes through models. To put %1 in its way, select it and press &quot;Make rigid body&quot; at the end of its properties.</source>
        <translation>Co teče, prochází modely. Má-li %1 stát v cestě, vyberte ho a stiskněte „Udělat tuhé těleso“ na konci jeho vlastností.</translation>
    </message>
    <message>
        <source>The ground round all %1 copies of %2 has small cover cells, which takes much time and memory. Switch that off for what stands in great numbers.</source>
        <translation>Zem kolem všech %1 kopií %2 má malé buňky pokrývky, což stojí mnoho času a paměti. U toho, čeho je mnoho, to vypněte.</translation>
    </message>
    <message>
        <source>Mist and powder come from what flows. Add a water source or an avalanche release.</source>
        <translation>Mlha a prach vznikají z toho, co teče. Přidejte zdroj vody nebo odtrh laviny.</translation>
    </message>
</context>
<context>
    <name>Viewport</name>
    <message>
        <source>Sun in %1°, %2° high</source>
        <translation>Slunce v azimutu %1°, výška %2°</translation>
    </message>
    <message>
        <source>Wind %1 m/s from %2°</source>
        <translation>Vítr %1 m/s od %2°</translation>
    </message>
    <message>
        <source>N</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Radius %1 m</source>
        <translation>Poloměr %1 m</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
</context>
<context>
    <name>spin::Application</name>
    <message>
        <source>Editor and simulator of winter scenes.</source>
        <translation>Editor a simulátor zimních scén.</translation>
    </message>
    <message>
        <source>Language of the window: en, cs or zh_CN.</source>
        <translation>Jazyk okna: en, cs nebo zh_CN.</translation>
    </message>
    <message>
        <source>Simulates, plays and exports the scene, writes how long the window stood still to FILE as JSON, and ends.</source>
        <translation>Scénu odsimuluje, přehraje a exportuje, do FILE zapíše jako JSON, jak dlouho okno stálo, a skončí.</translation>
    </message>
    <message>
        <source>Writes a picture of the window to FILE once the scene is simulated, and ends.</source>
        <translation>Po odsimulování scény zapíše obrázek okna do FILE a skončí.</translation>
    </message>
    <message>
        <source>A scene to open, or terrains and models to import.</source>
        <translation>Scéna k otevření, nebo terény a modely k importu.</translation>
    </message>
</context>
<context>
    <name>spin::Autosave</name>
    <message>
        <source>The folder for recovery copies cannot be used: %1</source>
        <translation>Složku pro záchranné kopie nelze použít: %1</translation>
    </message>
</context>
<context>
    <name>spin::BrushBar</name>
    <message>
        <source>What the brush paints; a selected painted node takes its place</source>
        <translation>Co štětec maluje; vybraný malovaný uzel má přednost</translation>
    </message>
    <message>
        <source>What the brush paints (Ctrl + click in the view picks it)</source>
        <translation>Co štětec maluje (Ctrl + klepnutí v pohledu hodnotu vezme)</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malovat</translation>
    </message>
    <message>
        <source>Smooth, also with Shift held</source>
        <translation>Vyhladit, také s klávesou Shift</translation>
    </message>
    <message>
        <source>Erase to not painted</source>
        <translation>Mazat do nenamalovaného stavu</translation>
    </message>
    <message>
        <source>Pick a value, also with Ctrl held</source>
        <translation>Vzít hodnotu, také s klávesou Ctrl</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Radius of the brush (F and move the pointer; [ and ]; Ctrl + wheel)</source>
        <translation>Poloměr štětce (F a pohyb ukazatele; [ a ]; Ctrl + kolečko)</translation>
    </message>
    <message>
        <source>Strength </source>
        <translation>Síla </translation>
    </message>
    <message>
        <source>How far a stroke goes towards the value (Shift+F and move the pointer)</source>
        <translation>Jak daleko tah dojde k hodnotě (Shift+F a pohyb ukazatele)</translation>
    </message>
    <message>
        <source>Hardness </source>
        <translation>Tvrdost </translation>
    </message>
    <message>
        <source>Share of the radius that has the full strength: the inner ring</source>
        <translation>Podíl poloměru s plnou silou: vnitřní kruh</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Pero</translation>
    </message>
    <message>
        <source>What the pressure of a pen changes</source>
        <translation>Co mění přítlak pera</translation>
    </message>
    <message>
        <source>Pressure changes the strength</source>
        <translation>Přítlak mění sílu</translation>
    </message>
    <message>
        <source>A light touch paints little</source>
        <translation>Lehký dotek maluje slabě</translation>
    </message>
    <message>
        <source>Pressure changes the radius</source>
        <translation>Přítlak mění poloměr</translation>
    </message>
    <message>
        <source>A light touch paints narrow</source>
        <translation>Lehký dotek maluje úzce</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Vrstva</translation>
    </message>
    <message>
        <source>What is done to the whole layer: fill, filters, files</source>
        <translation>Co se dělá s celou vrstvou: výplň, filtry, soubory</translation>
    </message>
    <message>
        <source>&amp;Fill...</source>
        <translation>Vy&amp;plnit...</translation>
    </message>
    <message>
        <source>Fill by altitude, slope and aspect</source>
        <translation>Vyplnit podle nadmořské výšky, sklonu a orientace</translation>
    </message>
    <message>
        <source>F&amp;ilter...</source>
        <translation>F&amp;iltr...</translation>
    </message>
    <message>
        <source>Blur, grow, shrink and more</source>
        <translation>Rozostření, rozšíření, zúžení a další</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Vymazat</translation>
    </message>
    <message>
        <source>Take away all that is painted</source>
        <translation>Odstranit vše namalované</translation>
    </message>
    <message>
        <source>I&amp;mport...</source>
        <translation>I&amp;mportovat...</translation>
    </message>
    <message>
        <source>Take the layer from a picture or a GeoTIFF</source>
        <translation>Vzít vrstvu z obrázku nebo GeoTIFF</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportovat...</translation>
    </message>
    <message>
        <source>Write the layer as a picture or a GeoTIFF</source>
        <translation>Zapsat vrstvu jako obrázek nebo GeoTIFF</translation>
    </message>
</context>
<context>
    <name>spin::ExportDialog</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>What to write</source>
        <translation>Co zapsat</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Snímky</translation>
    </message>
    <message>
        <source>to</source>
        <translation>až</translation>
    </message>
    <message>
        <source>Picture size</source>
        <translation>Velikost obrazu</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Vybrat...</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Složka</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Odhad</translation>
    </message>
    <message>
        <source>The same export on the command line</source>
        <translation>Stejný export na příkazovém řádku</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Příkaz</translation>
    </message>
    <message>
        <source>Folder for the export</source>
        <translation>Složka pro export</translation>
    </message>
    <message>
        <source>Choose at least one thing to write.</source>
        <translation>Vyberte aspoň jednu věc k zápisu.</translation>
    </message>
    <message>
        <source>The last frame lies before the first.</source>
        <translation>Poslední snímek leží před prvním.</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>Vyberte složku.</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s), about %1 on disk</source>
        <translation>
            <numerusform>%n snímek, asi %1 na disku</numerusform>
            <numerusform>%n snímky, asi %1 na disku</numerusform>
            <numerusform>%n snímků, asi %1 na disku</numerusform>
        </translation>
    </message>
    <message>
        <source>Starting...</source>
        <translation>Spouští se...</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zastavit</translation>
    </message>
    <message>
        <source>%p %, %1 left</source>
        <translation>%p %, zbývá %1</translation>
    </message>
    <message>
        <source>Written to &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;.</source>
        <translation>Zapsáno do &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;.</translation>
    </message>
    <message>
        <source>Stopped. Files written so far stay in the folder.</source>
        <translation>Zastaveno. Dosud zapsané soubory zůstávají ve složce.</translation>
    </message>
    <message>
        <source>The export failed.</source>
        <translation>Export selhal.</translation>
    </message>
    <message>
        <source>The export is still running.</source>
        <translation>Export ještě běží.</translation>
    </message>
    <message>
        <source>Stop it</source>
        <translation>Zastavit ho</translation>
    </message>
    <message>
        <source>Keep exporting</source>
        <translation>Pokračovat v exportu</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>Exportováno do %1.</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 d</translation>
    </message>
    <message>
        <source>%1 years</source>
        <translation>%1 r.</translation>
    </message>
</context>
<context>
    <name>spin::ExportJob</name>
    <message>
        <source>The export program ended unexpectedly.</source>
        <translation>Exportní program nečekaně skončil.</translation>
    </message>
    <message>
        <source>The export program could not be started: %1</source>
        <translation>Exportní program se nepodařilo spustit: %1</translation>
    </message>
</context>
<context>
    <name>spin::FileFlow</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Neuložené změny</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has changes that are not saved.</source>
        <translation>„%1“ obsahuje neuložené změny.</translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation>Otevřít scénu</translation>
    </message>
    <message>
        <source>Spindrift scenes (*.spindrift)</source>
        <translation>Scény Spindrift (*.spindrift)</translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation>Uložit scénu</translation>
    </message>
    <message>
        <source>Spindrift</source>
        <translation>Spindrift</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>scena</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Soubor se na disku změnil</translation>
    </message>
    <message>
        <source>Another program has changed &quot;%1&quot; since it was opened or saved here. Saving overwrites these changes.</source>
        <translation>Jiný program změnil „%1“ od doby, kdy byl zde otevřen nebo uložen. Uložení tyto změny přepíše.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Přepsat</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Uložit jako...</translation>
    </message>
</context>
<context>
    <name>spin::FillDialog</name>
    <message>
        <source>Fill: %1</source>
        <translation>Vyplnit: %1</translation>
    </message>
    <message>
        <source>What the layer is filled with</source>
        <translation>Čím se vrstva vyplní</translation>
    </message>
    <message>
        <source>How the value joins what is painted there</source>
        <translation>Jak se hodnota spojí s tím, co je namalováno</translation>
    </message>
    <message>
        <source>Replaces what is there</source>
        <translation>Nahradí, co tam je</translation>
    </message>
    <message>
        <source>The larger of both</source>
        <translation>Větší z obou</translation>
    </message>
    <message>
        <source>Is added</source>
        <translation>Přičte se</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Hodnota</translation>
    </message>
    <message>
        <source>Combine</source>
        <translation>Spojení</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Nadmořská výška</translation>
    </message>
    <message>
        <source>Height above sea</source>
        <translation>Výška nad mořem</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Sklon</translation>
    </message>
    <message>
        <source>Steepness from level ground</source>
        <translation>Strmost od vodorovné plochy</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Aspect</source>
        <translation>Orientace svahu</translation>
    </message>
    <message>
        <source>The way the ground faces, clockwise: 0 north, 90 east</source>
        <translation>Kam je svah obrácen, po směru hodin: 0 sever, 90 východ</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Vyplnit</translation>
    </message>
    <message>
        <source>Fill as the view shows it; one undo step</source>
        <translation>Vyplní tak, jak ukazuje pohled; jeden krok zpět</translation>
    </message>
    <message>
        <source>Where the range begins</source>
        <translation>Kde rozsah začíná</translation>
    </message>
    <message>
        <source>Where the range ends</source>
        <translation>Kde rozsah končí</translation>
    </message>
    <message>
        <source>Width of the soft edge on either side</source>
        <translation>Šířka měkkého okraje na obou stranách</translation>
    </message>
    <message>
        <source>to</source>
        <translation>až</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Od</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Měkký okraj</translation>
    </message>
    <message>
        <source>A quarter of the horizon by name</source>
        <translation>Čtvrtina obzoru podle světové strany</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Sever</translation>
    </message>
    <message>
        <source>North-east</source>
        <translation>Severovýchod</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Východ</translation>
    </message>
    <message>
        <source>South-east</source>
        <translation>Jihovýchod</translation>
    </message>
    <message>
        <source>South</source>
        <translation>Jih</translation>
    </message>
    <message>
        <source>South-west</source>
        <translation>Jihozápad</translation>
    </message>
    <message>
        <source>West</source>
        <translation>Západ</translation>
    </message>
    <message>
        <source>North-west</source>
        <translation>Severozápad</translation>
    </message>
    <message>
        <source>Own range</source>
        <translation>Vlastní rozsah</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Směřuje</translation>
    </message>
    <message>
        <source>Fills %1 % of the terrain, %2.</source>
        <translation>Vyplní %1 % terénu, %2.</translation>
    </message>
    <message>
        <source>%1 km²</source>
        <translation>%1 km²</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
</context>
<context>
    <name>spin::FilterDialog</name>
    <message>
        <source>Filter: %1</source>
        <translation>Filtr: %1</translation>
    </message>
    <message>
        <source>What the filter does</source>
        <translation>Co filtr dělá</translation>
    </message>
    <message>
        <source>How far the filter reaches</source>
        <translation>Kam až filtr dosáhne</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>What is less is taken away</source>
        <translation>Co je menší, zmizí</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtr</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Poloměr</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Práh</translation>
    </message>
    <message>
        <source>Filter as the view shows it; one undo step</source>
        <translation>Filtruje tak, jak ukazuje pohled; jeden krok zpět</translation>
    </message>
</context>
<context>
    <name>spin::FlakePanel</name>
    <message>
        <source>radius %1 mm</source>
        <translation>poloměr %1 mm</translation>
    </message>
    <message numerus="yes">
        <source>%n cell(s) of ice</source>
        <translation>
            <numerusform>%n buňka ledu</numerusform>
            <numerusform>%n buňky ledu</numerusform>
            <numerusform>%n buněk ledu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n particle(s)</source>
        <translation>
            <numerusform>%n částice</numerusform>
            <numerusform>%n částice</numerusform>
            <numerusform>%n částic</numerusform>
        </translation>
    </message>
    <message>
        <source>D = %1</source>
        <translation>D = %1</translation>
    </message>
    <message>
        <source>Apply flake</source>
        <translation>Použít vločku</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zastavit</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Pěstovat</translation>
    </message>
    <message>
        <source>Stop the growth; what has grown stays</source>
        <translation>Zastavit růst; co vyrostlo, zůstane</translation>
    </message>
    <message>
        <source>Grow a flake with these settings and watch it</source>
        <translation>Nechat vyrůst vločku s tímto nastavením a pozorovat ji</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Další</translation>
    </message>
    <message>
        <source>Grow another flake of the same kind: the next seed</source>
        <translation>Nechat vyrůst další vločku téhož druhu: příští semínko</translation>
    </message>
    <message>
        <source>Apply to scene</source>
        <translation>Použít ve scéně</translation>
    </message>
    <message>
        <source>Let the scene&apos;s flakes grow like this one</source>
        <translation>Ať vločky scény rostou jako tato</translation>
    </message>
    <message>
        <source>The flake as it grows</source>
        <translation>Vločka, jak roste</translation>
    </message>
    <message>
        <source>Size of the flake and its fractal dimension by the radius of gyration</source>
        <translation>Velikost vločky a její fraktální rozměr podle poloměru setrvačnosti</translation>
    </message>
    <message>
        <source>Nothing has grown yet</source>
        <translation>Ještě nic nevyrostlo</translation>
    </message>
</context>
<context>
    <name>spin::ImportDialog</name>
    <message>
        <source>Import terrain</source>
        <translation>Import terénu</translation>
    </message>
    <message>
        <source>Import model</source>
        <translation>Import modelu</translation>
    </message>
    <message>
        <source>Reading...</source>
        <translation>Načítá se...</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importovat</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Načíst znovu</translation>
    </message>
    <message>
        <source>Reads the file with the options above</source>
        <translation>Načte soubor s volbami výše</translation>
    </message>
    <message>
        <source>From the file</source>
        <translation>Podle souboru</translation>
    </message>
    <message>
        <source>EPSG code</source>
        <translation>Kód EPSG</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>From the file, or 1 m</source>
        <translation>Podle souboru, jinak 1 m</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Velikost buňky</translation>
    </message>
    <message>
        <source>Height unit</source>
        <translation>Jednotka výšky</translation>
    </message>
    <message>
        <source>Cells with this value are holes:</source>
        <translation>Buňky s touto hodnotou jsou díry:</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>Podle souboru</translation>
    </message>
    <message>
        <source>Y is up</source>
        <translation>Nahoru míří Y</translation>
    </message>
    <message>
        <source>Z is up</source>
        <translation>Nahoru míří Z</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Svislá osa</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Jednotka souboru</translation>
    </message>
    <message>
        <source>Copy beside the scene</source>
        <translation>Zkopírovat ke scéně</translation>
    </message>
    <message>
        <source>Copies the file and what it refers to into the scene&apos;s folder, so that the scene can be moved. A scene without a folder gets the copy when it is saved.</source>
        <translation>Zkopíruje soubor i to, na co odkazuje, do složky scény, takže scénu lze přesunout. Scéna bez složky dostane kopii při uložení.</translation>
    </message>
</context>
<context>
    <name>spin::ImportFlow</name>
    <message>
        <source>Import terrain or model</source>
        <translation>Importovat terén nebo model</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a terrain nor a model this program reads.</source>
        <translation>„%1“ není terén ani model, který program umí načíst.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importovat</translation>
    </message>
    <message>
        <source>Import terrain</source>
        <translation>Import terénu</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Nahradit</translation>
    </message>
    <message>
        <source>Its coordinates, credit line, name and import options go with it.</source>
        <translation>S ním zmizí jeho souřadnice, uvedení zdroje, název i volby importu.</translation>
    </message>
    <message>
        <source>What is painted on it (%1) is kept cell by cell if the new terrain has as many columns and rows. Otherwise it is left out, and the list of issues says so.</source>
        <translation>Co je na něm namalováno (%1), zůstane buňku po buňce, má-li nový terén stejně sloupců a řádků. Jinak se to vynechá a seznam problémů to oznámí.</translation>
    </message>
    <message>
        <source>Replace the terrain &quot;%1&quot;?</source>
        <translation>Nahradit terén „%1“?</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not imported: another scene was opened meanwhile.</source>
        <translation>„%1“ se neimportoval: mezitím byla otevřena jiná scéna.</translation>
    </message>
    <message>
        <source>Copied to &quot;%1&quot;.</source>
        <translation>Zkopírováno do „%1“.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; will be copied beside the scene when it is saved.</source>
        <translation>„%1“ se zkopíruje ke scéně, až se uloží.</translation>
    </message>
    <message>
        <source>The file stays where it is; scenes may use the folder &quot;%1&quot; from now on.</source>
        <translation>Soubor zůstává na místě; scény od nynějška smějí používat složku „%1“.</translation>
    </message>
    <message>
        <source>All files lie in the scene&apos;s folder already; nothing was copied.</source>
        <translation>Všechny soubory už leží ve složce scény; nic se nekopírovalo.</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) copied to &quot;%1&quot;. Save the scene to use them from there.</source>
        <translation>
            <numerusform>%n soubor zkopírován do „%1“. Uložte scénu, aby ho používala odtud.</numerusform>
            <numerusform>%n soubory zkopírovány do „%1“. Uložte scénu, aby je používala odtud.</numerusform>
            <numerusform>%n souborů zkopírováno do „%1“. Uložte scénu, aby je používala odtud.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spin::ImportJob</name>
    <message>
        <source>Terrain and models</source>
        <translation>Terén a modely</translation>
    </message>
    <message>
        <source>Elevation models</source>
        <translation>Výškové modely</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modely</translation>
    </message>
</context>
<context>
    <name>spin::IssueModel</name>
    <message>
        <source>Scene</source>
        <translation>Scéna</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>Uzel</translation>
    </message>
    <message>
        <source>Issue</source>
        <translation>Problém</translation>
    </message>
</context>
<context>
    <name>spin::IssuesPanel</name>
    <message>
        <source>No issues</source>
        <translation>Žádné problémy</translation>
    </message>
</context>
<context>
    <name>spin::LayerFileDialog</name>
    <message>
        <source>Export: %1</source>
        <translation>Export: %1</translation>
    </message>
    <message>
        <source>Import: %1</source>
        <translation>Import: %1</translation>
    </message>
    <message>
        <source>GeoTIFF keeps the values and where nothing is painted; a PNG is a grey picture</source>
        <translation>GeoTIFF uchová hodnoty i to, kde není nic namalováno; PNG je šedý obrázek</translation>
    </message>
    <message>
        <source>GeoTIFF</source>
        <translation>GeoTIFF</translation>
    </message>
    <message>
        <source>PNG, 8 bit</source>
        <translation>PNG, 8 bitů</translation>
    </message>
    <message>
        <source>PNG, 16 bit</source>
        <translation>PNG, 16 bitů</translation>
    </message>
    <message>
        <source>What black stands for</source>
        <translation>Co znamená černá</translation>
    </message>
    <message>
        <source>What white stands for</source>
        <translation>Co znamená bílá</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formát</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Černá</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Bílá</translation>
    </message>
    <message>
        <source>Choose file...</source>
        <translation>Vybrat soubor...</translation>
    </message>
    <message>
        <source>Choose where to write</source>
        <translation>Vybrat, kam zapsat</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importovat</translation>
    </message>
    <message>
        <source>Take the file as the view shows it; one undo step</source>
        <translation>Převezme soubor tak, jak ukazuje pohled; jeden krok zpět</translation>
    </message>
    <message>
        <source>What is not painted becomes black.</source>
        <translation>Co není namalováno, bude černé.</translation>
    </message>
    <message>
        <source>%1 x %2 cells</source>
        <translation>%1 x %2 buněk</translation>
    </message>
    <message>
        <source>real numbers</source>
        <translation>reálná čísla</translation>
    </message>
    <message>
        <source>%1 bit</source>
        <translation>%1 bitů</translation>
    </message>
    <message>
        <source>with its place in the world</source>
        <translation>s umístěním ve světě</translation>
    </message>
    <message>
        <source>laid over the whole terrain</source>
        <translation>položeno přes celý terén</translation>
    </message>
</context>
<context>
    <name>spin::LayerTools</name>
    <message>
        <source>Written: %1</source>
        <translation>Zapsáno: %1</translation>
    </message>
    <message>
        <source>The painted layers are still being read.</source>
        <translation>Malované vrstvy se ještě načítají.</translation>
    </message>
    <message>
        <source>There is no terrain to paint on: import one first.</source>
        <translation>Není terén, na který by se malovalo: nejprve jej importujte.</translation>
    </message>
    <message>
        <source>Fill %1</source>
        <translation>Vyplnit: %1</translation>
    </message>
    <message>
        <source>Filters work on temperature, depth and keep-clear layers; for ground types there is the smoothing brush.</source>
        <translation>Filtry pracují s vrstvami teploty, výšky sněhu a udržování bez sněhu; pro typy povrchu je vyhlazovací štětec.</translation>
    </message>
    <message>
        <source>No plugin with filters is installed.</source>
        <translation>Není nainstalován žádný modul s filtry.</translation>
    </message>
    <message>
        <source>Filter %1</source>
        <translation>Filtrovat: %1</translation>
    </message>
    <message>
        <source>Import a layer</source>
        <translation>Import vrstvy</translation>
    </message>
    <message>
        <source>Rasters (*.png *.tif *.tiff *.asc *.xyz)</source>
        <translation>Rastry (*.png *.tif *.tiff *.asc *.xyz)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importovat: %1</translation>
    </message>
    <message>
        <source>Export a layer</source>
        <translation>Export vrstvy</translation>
    </message>
    <message>
        <source>Clear %1</source>
        <translation>Vymazat: %1</translation>
    </message>
    <message>
        <source>The last change of a layer is still being worked out.</source>
        <translation>Poslední změna vrstvy se ještě počítá.</translation>
    </message>
</context>
<context>
    <name>spin::MainActions</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Soubor</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nová</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Otevřít...</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Otevřít n&amp;edávné</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Uložit</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Uložit &amp;jako...</translation>
    </message>
    <message>
        <source>&amp;Collect files beside the scene</source>
        <translation>&amp;Sebrat soubory ke scéně</translation>
    </message>
    <message>
        <source>&amp;Import terrain or model...</source>
        <translation>&amp;Importovat terén nebo model...</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportovat...</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>U&amp;končit</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Ú&amp;pravy</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Zpět</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Zn&amp;ovu</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplikovat</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>S&amp;mazat</translation>
    </message>
    <message>
        <source>Set &amp;keys</source>
        <translation>Vložit &amp;klíče</translation>
    </message>
    <message>
        <source>&amp;Add node</source>
        <translation>&amp;Přidat uzel</translation>
    </message>
    <message>
        <source>%1...</source>
        <translation>%1...</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Zobrazení</translation>
    </message>
    <message>
        <source>&amp;Frame selection</source>
        <translation>&amp;Najet na výběr</translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation>Najet na &amp;vše</translation>
    </message>
    <message>
        <source>&amp;Look through the camera</source>
        <translation>&amp;Dívat se kamerou</translation>
    </message>
    <message>
        <source>&amp;Set the camera from the view</source>
        <translation>Na&amp;stavit kameru podle pohledu</translation>
    </message>
    <message>
        <source>S&amp;now cover</source>
        <translation>Sně&amp;hová pokrývka</translation>
    </message>
    <message>
        <source>Fa&amp;lling flakes</source>
        <translation>Padající &amp;vločky</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>&amp;Obnovit rozložení</translation>
    </message>
    <message>
        <source>&amp;Ground shows</source>
        <translation>&amp;Povrch ukazuje</translation>
    </message>
    <message>
        <source>&amp;Natural colours</source>
        <translation>&amp;Přirozené barvy</translation>
    </message>
    <message>
        <source>Ground &amp;types</source>
        <translation>&amp;Typy povrchu</translation>
    </message>
    <message>
        <source>Ground t&amp;emperature</source>
        <translation>T&amp;eplotu povrchu</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>S&amp;imulace</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>Za&amp;stavit</translation>
    </message>
    <message>
        <source>Simulate &amp;after edits</source>
        <translation>Simulovat &amp;po úpravách</translation>
    </message>
    <message>
        <source>&amp;Delete out-of-date frames from disk</source>
        <translation>&amp;Smazat zastaralé snímky z disku</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Přehrát nebo pozastavit</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Předchozí snímek</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Další snímek</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>První snímek</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Poslední snímek</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Nástroje</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Vybrat</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Posunout</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Otočit</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Měřítko</translation>
    </message>
    <message>
        <source>Local axes</source>
        <translation>Místní osy</translation>
    </message>
    <message>
        <source>Handles along the model&apos;s own axes (X)</source>
        <translation>Úchyty podél vlastních os modelu (X)</translation>
    </message>
    <message>
        <source>Smaller brush</source>
        <translation>Menší štětec</translation>
    </message>
    <message>
        <source>Larger brush</source>
        <translation>Větší štětec</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Nápověda</translation>
    </message>
    <message>
        <source>&amp;Keys and pointer</source>
        <translation>&amp;Klávesy a ukazatel</translation>
    </message>
    <message>
        <source>&amp;About Spindrift</source>
        <translation>&amp;O programu Spindrift</translation>
    </message>
    <message>
        <source>Middle button, Alt + left</source>
        <translation>Prostřední tlačítko, Alt + levé</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Otáčet pohled</translation>
    </message>
    <message>
        <source>Shift + middle button</source>
        <translation>Shift + prostřední tlačítko</translation>
    </message>
    <message>
        <source>Shift the view</source>
        <translation>Posouvat pohled</translation>
    </message>
    <message>
        <source>Wheel, Ctrl + middle button</source>
        <translation>Kolečko, Ctrl + prostřední tlačítko</translation>
    </message>
    <message>
        <source>Nearer and farther</source>
        <translation>Blíž a dál</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klepnutí</translation>
    </message>
    <message>
        <source>Ctrl while dragging a handle</source>
        <translation>Ctrl při tažení úchytu</translation>
    </message>
    <message>
        <source>Whole steps: 1 m, 15 degrees, 0.1</source>
        <translation>Celé kroky: 1 m, 15 stupňů, 0,1</translation>
    </message>
    <message>
        <source>Escape while dragging</source>
        <translation>Escape při tažení</translation>
    </message>
    <message>
        <source>Take the drag back</source>
        <translation>Vzít tažení zpět</translation>
    </message>
    <message>
        <source>Keys and pointer</source>
        <translation>Klávesy a ukazatel</translation>
    </message>
    <message>
        <source>About Spindrift</source>
        <translation>O programu Spindrift</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Spindrift %1&lt;/h3&gt;&lt;p&gt;Editor and simulator of winter scenes.&lt;/p&gt;&lt;p&gt;Apache License 2.0. What it builds on is listed in the file NOTICE.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Spindrift %1&lt;/h3&gt;&lt;p&gt;Editor a simulátor zimních scén.&lt;/p&gt;&lt;p&gt;Licence Apache 2.0. Na čem program staví, uvádí soubor NOTICE.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Flo&amp;w shows</source>
        <translation>&amp;Tok ukazuje</translation>
    </message>
    <message>
        <source>&amp;Boundary particles</source>
        <translation>&amp;Hraniční částice</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pozastavit</translation>
    </message>
    <message>
        <source>Hold the simulation; it goes on where it was</source>
        <translation>Podržet simulaci; pokračuje, kde byla</translation>
    </message>
    <message>
        <source>S&amp;ingle step</source>
        <translation>Jeden &amp;krok</translation>
    </message>
    <message>
        <source>Hold the simulation and compute one frame further</source>
        <translation>Podržet simulaci a spočítat o jeden snímek dál</translation>
    </message>
    <message>
        <source>Pause s&amp;now from here</source>
        <translation>Pozastavit &amp;sníh odtud</translation>
    </message>
    <message>
        <source>Snowfall and cover stand still from the shown frame on</source>
        <translation>Sněžení a pokrývka stojí od zobrazeného snímku dál</translation>
    </message>
    <message>
        <source>Pause &amp;flow from here</source>
        <translation>Pozastavit t&amp;ok odtud</translation>
    </message>
    <message>
        <source>Avalanches, water and bodies stand still from the shown frame on</source>
        <translation>Laviny, voda a tělesa stojí od zobrazeného snímku dál</translation>
    </message>
    <message>
        <source>Reset the simulation</source>
        <translation>Začít simulaci znovu</translation>
    </message>
    <message>
        <source>All simulated frames of this scene are thrown away, in memory and on disk, and the simulation starts again at the first frame.</source>
        <translation>Všechny spočítané snímky této scény se zahodí, v paměti i na disku, a simulace začne znovu prvním snímkem.</translation>
    </message>
    <message>
        <source>&amp;Reset...</source>
        <translation>&amp;Začít znovu...</translation>
    </message>
    <message>
        <source>Throw away all simulated frames and start again</source>
        <translation>Zahodit všechny spočítané snímky a začít znovu</translation>
    </message>
    <message>
        <source>Draw the outline of a release</source>
        <translation>Kreslit obrys odtrhu</translation>
    </message>
    <message>
        <source>Up and down instead of along the ground</source>
        <translation>Nahoru a dolů místo po zemi</translation>
    </message>
    <message>
        <source>Click with the outline tool</source>
        <translation>Kliknutí s nástrojem obrysu</translation>
    </message>
    <message>
        <source>Add a corner; on a side, put one in</source>
        <translation>Přidat roh; na straně roh vložit</translation>
    </message>
    <message>
        <source>Delete over a corner</source>
        <translation>Delete nad rohem</translation>
    </message>
    <message>
        <source>Take the corner out</source>
        <translation>Roh odebrat</translation>
    </message>
    <message>
        <source>&amp;Painted layer</source>
        <translation>&amp;Malovaná vrstva</translation>
    </message>
    <message>
        <source>Painted snow &amp;depth</source>
        <translation>Malovaná &amp;výška sněhu</translation>
    </message>
    <message>
        <source>What is &amp;kept clear</source>
        <translation>Co se udržuje &amp;bez sněhu</translation>
    </message>
    <message>
        <source>The &amp;painted layer while painting</source>
        <translation>&amp;Malovaná vrstva při malování</translation>
    </message>
    <message>
        <source>Paint ground types, temperature, snow depth, what is kept clear, or the selected release</source>
        <translation>Malovat typy povrchu, teplotu, výšku sněhu, plochy bez sněhu nebo vybraný odtrh</translation>
    </message>
    <message>
        <source>F, Shift + F with the brush</source>
        <translation>F, Shift + F se štětcem</translation>
    </message>
    <message>
        <source>Radius and strength by moving the pointer</source>
        <translation>Poloměr a síla pohybem ukazatele</translation>
    </message>
    <message>
        <source>Shift, Ctrl with the brush</source>
        <translation>Shift, Ctrl se štětcem</translation>
    </message>
    <message>
        <source>Smooth; pick the value under the pointer</source>
        <translation>Vyhladit; vzít hodnotu pod ukazatelem</translation>
    </message>
    <message>
        <source>&amp;Values under the pointer</source>
        <translation>&amp;Hodnoty pod ukazatelem</translation>
    </message>
    <message>
        <source>A line at the lower left: depth, mass and temperature of the snow under the pointer, and the type of the ground.</source>
        <translation>Řádek vlevo dole: výška, hmotnost a teplota sněhu pod ukazatelem a druh povrchu.</translation>
    </message>
    <message>
        <source>Snow s&amp;hows</source>
        <translation>Sní&amp;h ukazuje</translation>
    </message>
    <message>
        <source>Colours the snow cover by this value, here and in exported pictures; the range of colours is set at the picture settings.</source>
        <translation>Obarví sněhovou pokrývku touto hodnotou, zde i v exportovaných obrázcích; rozsah barev se nastavuje v nastavení obrázku.</translation>
    </message>
    <message>
        <source>&amp;Published shading (Blinn-Phong)</source>
        <translation>&amp;Zveřejněné osvětlení (Blinn-Phong)</translation>
    </message>
    <message>
        <source>Lights the snow by ambient, diffuse and mirrored light as published, instead of the physically based way.</source>
        <translation>Osvětlí sníh okolním, rozptýleným a zrcadleným světlem, jak bylo zveřejněno, místo fyzikálně založeného způsobu.</translation>
    </message>
    <message>
        <source>&amp;Hints of the tools</source>
        <translation>&amp;Nápovědy nástrojů</translation>
    </message>
    <message>
        <source>Scatter copies of a model over the ground</source>
        <translation>Rozmístit kopie modelu po zemi</translation>
    </message>
    <message>
        <source>Shift while dragging a handle</source>
        <translation>Shift při tažení úchytu</translation>
    </message>
    <message>
        <source>Shift with copies</source>
        <translation>Shift u kopií</translation>
    </message>
    <message>
        <source>Take copies away</source>
        <translation>Odebrat kopie</translation>
    </message>
    <message>
        <source>Ctrl + click with copies</source>
        <translation>Ctrl + klepnutí u kopií</translation>
    </message>
    <message>
        <source>Choose the model that is copied</source>
        <translation>Vybrat model, který se kopíruje</translation>
    </message>
    <message>
        <source>The particles on the surface of rigid bodies that the flow pushes against; terrain has none</source>
        <translation>Částice na povrchu tuhých těles, o které se proud opírá; terén žádné nemá</translation>
    </message>
    <message>
        <source>&amp;Air shows</source>
        <translation>V&amp;zduch ukazuje</translation>
    </message>
    <message>
        <source>Colours mist and powder in the air by this value, here and in exported pictures; the range of colours is set at the picture settings.</source>
        <translation>Obarví mlhu a sněhový prach ve vzduchu touto hodnotou, zde i v exportovaných obrázcích; rozsah barev se nastavuje v nastavení obrázku.</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Řez</translation>
    </message>
    <message>
        <source>Shows the value on a plane across this axis instead of in the whole cloud; where the plane stands is set at the picture settings.</source>
        <translation>Ukáže hodnotu na rovině kolmé k této ose místo v celém oblaku; poloha roviny se nastavuje v nastavení obrázku.</translation>
    </message>
    <message>
        <source>Pause &amp;mist and powder from here</source>
        <translation>Pozastavit odtud &amp;mlhu a prach</translation>
    </message>
    <message>
        <source>Mist, powder and spray stand still from the shown frame on</source>
        <translation>Od zobrazeného snímku mlha, prach a tříšť stojí</translation>
    </message>
    <message>
        <source>Show a slice of the air</source>
        <translation>Ukázat řez vzduchem</translation>
    </message>
</context>
<context>
    <name>spin::MainWindow</name>
    <message>
        <source>Saved.</source>
        <translation>Uloženo.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scéna</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Vlastnosti</translation>
    </message>
    <message>
        <source>Issues</source>
        <translation>Problémy</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Časová osa</translation>
    </message>
    <message>
        <source>Drop an elevation model here</source>
        <translation>Přetáhněte sem výškový model</translation>
    </message>
    <message>
        <source>or use File &gt; Import. It snows on the first terrain of a scene; models (glTF, OBJ, PLY) are placed where the view looks.</source>
        <translation>nebo použijte Soubor &gt; Importovat. Na první terén scény hned sněží; modely (glTF, OBJ, PLY) se postaví tam, kam míří pohled.</translation>
    </message>
    <message>
        <source>%1[*] - Spindrift</source>
        <translation>%1[*] - Spindrift</translation>
    </message>
    <message>
        <source>Unsaved work found</source>
        <translation>Nalezena neuložená práce</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not saved. Its last changes were kept on %2.</source>
        <translation>„%1“ nebylo uloženo. Poslední změny byly uchovány %2.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Obnovit</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Smazat</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Později</translation>
    </message>
    <message>
        <source>Save first</source>
        <translation>Nejprve uložit</translation>
    </message>
    <message>
        <source>Exports are made from the saved scene. Save it now?</source>
        <translation>Exportuje se uložená scéna. Uložit ji nyní?</translation>
    </message>
    <message numerus="yes">
        <source>The recovered scene is open; %n file(s) of the command line were not opened.</source>
        <translation>
            <numerusform>Je otevřena obnovená scéna; %n soubor z příkazové řádky nebyl otevřen.</numerusform>
            <numerusform>Je otevřena obnovená scéna; %n soubory z příkazové řádky nebyly otevřeny.</numerusform>
            <numerusform>Je otevřena obnovená scéna; %n souborů z příkazové řádky nebylo otevřeno.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Fáze</translation>
    </message>
    <message>
        <source>Flake</source>
        <translation>Vločka</translation>
    </message>
</context>
<context>
    <name>spin::OutlinerPanel</name>
    <message>
        <source>Add</source>
        <translation>Přidat</translation>
    </message>
    <message>
        <source>Add a node to the scene</source>
        <translation>Přidat uzel do scény</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Přejmenovat</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplikovat</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odebrat</translation>
    </message>
    <message>
        <source>The scene has one already</source>
        <translation>Scéna už jeden má</translation>
    </message>
</context>
<context>
    <name>spin::PathEditor</name>
    <message>
        <source>Choose a file</source>
        <translation>Vyberte soubor</translation>
    </message>
</context>
<context>
    <name>spin::PictureView</name>
    <message>
        <source>There is no screen here. Everything but the picture works.</source>
        <translation>Není zde obrazovka. Kromě obrazu vše funguje.</translation>
    </message>
    <message>
        <source>The scene cannot be drawn here. Everything else works.
%1</source>
        <translation>Scénu zde nelze vykreslit. Vše ostatní funguje.
%1</translation>
    </message>
</context>
<context>
    <name>spin::PointsEditor</name>
    <message>
        <source>east north; east north; ...</source>
        <translation>východ sever; východ sever; ...</translation>
    </message>
</context>
<context>
    <name>spin::PropertyPanel</name>
    <message>
        <source>Nothing is selected</source>
        <translation>Nic není vybráno</translation>
    </message>
    <message>
        <source>Make rigid body</source>
        <translation>Udělat tuhé těleso</translation>
    </message>
    <message>
        <source>Make this model solid for avalanches and water, or show the body that does so</source>
        <translation>Udělat z modelu pevnou překážku lavin a vody, nebo ukázat těleso, které jí už je</translation>
    </message>
</context>
<context>
    <name>spin::PropertyRowEditor</name>
    <message>
        <source>Back to the default</source>
        <translation>Zpět na výchozí hodnotu</translation>
    </message>
    <message>
        <source>Set a key: animate this property</source>
        <translation>Vložit klíč: animovat tuto vlastnost</translation>
    </message>
    <message>
        <source>Animated; set a key at this frame</source>
        <translation>Animováno; vložit klíč na tomto snímku</translation>
    </message>
    <message>
        <source>Remove the key at this frame</source>
        <translation>Odebrat klíč na tomto snímku</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Skokem</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Lineárně</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Plynule</translation>
    </message>
</context>
<context>
    <name>spin::ScatterBar</name>
    <message>
        <source>The model that is copied (Ctrl + click in the view chooses it)</source>
        <translation>Model, který se kopíruje (vybere ho Ctrl + klepnutí v pohledu)</translation>
    </message>
    <message>
        <source>No model</source>
        <translation>Žádný model</translation>
    </message>
    <message>
        <source>Scatter copies</source>
        <translation>Rozmístit kopie</translation>
    </message>
    <message>
        <source>Take copies away, also with Shift held</source>
        <translation>Odebrat kopie, také se stisknutým Shiftem</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Radius of the brush (F and move the pointer; [ and ]; Ctrl + wheel)</source>
        <translation>Poloměr štětce (F a pohyb ukazatele; [ a ]; Ctrl + kolečko)</translation>
    </message>
    <message>
        <source> per 100 m²</source>
        <translation> na 100 m²</translation>
    </message>
    <message>
        <source>How many copies stand on 100 m²; a stroke fills up to this</source>
        <translation>Kolik kopií stojí na 100 m²; tah doplňuje do tohoto počtu</translation>
    </message>
    <message>
        <source>Apart </source>
        <translation>Odstup </translation>
    </message>
    <message>
        <source>Distance between copies at least</source>
        <translation>Nejmenší vzdálenost mezi kopiemi</translation>
    </message>
    <message>
        <source>Turn </source>
        <translation>Otočení </translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Range within which all copies of the model are turned at random</source>
        <translation>Rozsah, v němž jsou všechny kopie modelu náhodně otočeny</translation>
    </message>
    <message>
        <source>Size ±</source>
        <translation>Velikost ±</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How much larger or smaller all copies of the model are at random</source>
        <translation>O kolik jsou všechny kopie modelu náhodně větší nebo menší</translation>
    </message>
</context>
<context>
    <name>spin::SceneDocument</name>
    <message>
        <source>Untitled</source>
        <translation>Bez názvu</translation>
    </message>
    <message>
        <source>The scene has no file name yet.</source>
        <translation>Scéna ještě nemá název souboru.</translation>
    </message>
    <message>
        <source>The scene is being saved already.</source>
        <translation>Scéna se už ukládá.</translation>
    </message>
</context>
<context>
    <name>spin::SceneLock</name>
    <message>
        <source>This scene is open in another window of the program too. Whoever saves last overwrites what the other has saved.</source>
        <translation>Tato scéna je otevřena i v jiném okně programu. Kdo uloží poslední, přepíše to, co uložil ten druhý.</translation>
    </message>
</context>
<context>
    <name>spin::SceneTools</name>
    <message>
        <source>The painted layers are still being read.</source>
        <translation>Malované vrstvy se ještě načítají.</translation>
    </message>
    <message>
        <source>Paint ground</source>
        <translation>Malovat povrch</translation>
    </message>
    <message>
        <source>Set camera from view</source>
        <translation>Nastavit kameru podle pohledu</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Select a node first: keys are set on its animated properties.</source>
        <translation>Nejprve vyberte uzel: klíče se vkládají na jeho animované vlastnosti.</translation>
    </message>
    <message>
        <source>Nothing of this node is animated yet: use the key buttons beside its properties.</source>
        <translation>Na tomto uzlu zatím není nic animováno: použijte tlačítka klíčů u vlastností.</translation>
    </message>
    <message>
        <source>Set keys</source>
        <translation>Vložit klíče</translation>
    </message>
    <message>
        <source>Draw release outline</source>
        <translation>Kreslit obrys odtrhu</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Přidat %1</translation>
    </message>
    <message>
        <source>Change pictures</source>
        <translation>Změnit snímky</translation>
    </message>
    <message>
        <source>Pause process</source>
        <translation>Pozastavit děj</translation>
    </message>
    <message>
        <source>Let process go on</source>
        <translation>Nechat děj pokračovat</translation>
    </message>
    <message>
        <source>Make rigid body</source>
        <translation>Udělat tuhé těleso</translation>
    </message>
</context>
<context>
    <name>spin::SimulationController</name>
    <message>
        <source>Simulation stopped.</source>
        <translation>Simulace zastavena.</translation>
    </message>
    <message>
        <source>Stale frames deleted.</source>
        <translation>Zastaralé snímky smazány.</translation>
    </message>
    <message>
        <source>Simulation held; P goes on.</source>
        <translation>Simulace pozastavena; P pokračuje.</translation>
    </message>
</context>
<context>
    <name>spin::StagePanel</name>
    <message>
        <source>Frame %1</source>
        <translation>Snímek %1</translation>
    </message>
    <message>
        <source>No frame is simulated yet</source>
        <translation>Zatím není spočítán žádný snímek</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>All stages</source>
        <translation>Všechny fáze</translation>
    </message>
    <message>
        <source>Computed on</source>
        <translation>Spočítáno na</translation>
    </message>
    <message>
        <source>Mass: %1</source>
        <translation>Hmotnost: %1</translation>
    </message>
    <message>
        <source>%1 kg</source>
        <translation>%1 kg</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Fáze</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Čas</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Podíl</translation>
    </message>
    <message>
        <source>Calls</source>
        <translation>Volání</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Údaj</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Hodnota</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopírovat</translation>
    </message>
    <message>
        <source>Copy both tables as text</source>
        <translation>Kopírovat obě tabulky jako text</translation>
    </message>
</context>
<context>
    <name>spin::StatusPanel</name>
    <message>
        <source>%1 s per frame, %2 %3 %</source>
        <translation>%1 s na snímek, %2 %3 %</translation>
    </message>
    <message>
        <source>Stop the simulation</source>
        <translation>Zastavit simulaci</translation>
    </message>
    <message>
        <source>Simulated frames in memory and on disk</source>
        <translation>Simulované snímky v paměti a na disku</translation>
    </message>
    <message>
        <source>Time to draw the last picture of the view</source>
        <translation>Doba kreslení posledního obrazu pohledu</translation>
    </message>
    <message>
        <source>What simulates: instruction set of the processor, or graphics card</source>
        <translation>Co simuluje: instrukční sada procesoru, nebo grafická karta</translation>
    </message>
    <message>
        <source>Reading files...</source>
        <translation>Načítají se soubory...</translation>
    </message>
    <message>
        <source>Simulating...</source>
        <translation>Simuluje se...</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Snímek %1 z %2</translation>
    </message>
    <message>
        <source>Frame %1 of %2, %3 left</source>
        <translation>Snímek %1 z %2, zbývá %3</translation>
    </message>
    <message>
        <source>Cache %1</source>
        <translation>Mezipaměť %1</translation>
    </message>
    <message>
        <source>Simulated frames: %1 in memory, %2 on disk, of these %3 out of date</source>
        <translation>Simulované snímky: %1 v paměti, %2 na disku, z toho %3 zastaralých</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 particles</source>
        <translation>%1 částic</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>asi %1</translation>
    </message>
    <message>
        <source>%1 of memory</source>
        <translation>%1 paměti</translation>
    </message>
    <message>
        <source>%1 on disk</source>
        <translation>%1 na disku</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s): %1</source>
        <translation>
            <numerusform>%n snímek: %1</numerusform>
            <numerusform>%n snímky: %1</numerusform>
            <numerusform>%n snímků: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>What the frames that are not simulated yet will take</source>
        <translation>Co budou stát snímky, které ještě nejsou spočítány</translation>
    </message>
    <message>
        <source>How far one sees through the falling snow: there a dark object keeps 2 % of its contrast</source>
        <translation>Jak daleko je vidět padajícím sněhem: tmavému předmětu tam zbývají 2 % kontrastu</translation>
    </message>
    <message>
        <source>Growing the shapes of the flakes; a click stops it</source>
        <translation>Rostou tvary vloček; klepnutí je zastaví</translation>
    </message>
    <message>
        <source>Growing flakes %1 %</source>
        <translation>Rostou vločky %1 %</translation>
    </message>
    <message>
        <source>Sight %1 km</source>
        <translation>Dohlednost %1 km</translation>
    </message>
    <message>
        <source>Sight %1 m</source>
        <translation>Dohlednost %1 m</translation>
    </message>
</context>
<context>
    <name>spin::TimelineBar</name>
    <message>
        <source>Frame %1: simulated</source>
        <translation>Snímek %1: simulován</translation>
    </message>
    <message>
        <source>Frame %1: from before the last change</source>
        <translation>Snímek %1: z doby před poslední změnou</translation>
    </message>
    <message>
        <source>Frame %1: not simulated yet</source>
        <translation>Snímek %1: dosud nesimulován</translation>
    </message>
</context>
<context>
    <name>spin::TimelinePanel</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>First frame (Home)</source>
        <translation>První snímek (Home)</translation>
    </message>
    <message>
        <source>Previous frame (Left)</source>
        <translation>Předchozí snímek (šipka vlevo)</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pozastavit (mezerník)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Přehrát (mezerník)</translation>
    </message>
    <message>
        <source>Next frame (Right)</source>
        <translation>Další snímek (šipka vpravo)</translation>
    </message>
    <message>
        <source>Last frame (End)</source>
        <translation>Poslední snímek (End)</translation>
    </message>
    <message>
        <source>Current frame</source>
        <translation>Aktuální snímek</translation>
    </message>
</context>
<context>
    <name>spin::Viewport</name>
    <message>
        <source>Camera view</source>
        <translation>Pohled kamery</translation>
    </message>
    <message>
        <source>Radius %1 m</source>
        <translation>Poloměr %1 m</translation>
    </message>
    <message>
        <source>Strength %1 %</source>
        <translation>Síla %1 %</translation>
    </message>
    <message>
        <source>Nothing is painted here</source>
        <translation>Zde není nic namalováno</translation>
    </message>
    <message>
        <source>There is no terrain to paint on: import one first</source>
        <translation>Není terén, na který by se malovalo: nejprve ho importujte</translation>
    </message>
    <message>
        <source>Drag to paint. F: radius, Shift + F: strength, Shift: smooth, Ctrl: pick, D: erase</source>
        <translation>Tažením malujte. F: poloměr, Shift + F: síla, Shift: vyhladit, Ctrl: nabrat, D: mazat</translation>
    </message>
    <message>
        <source>There is no terrain to scatter on: import one first</source>
        <translation>Není terén, na který by se rozmisťovalo: nejprve ho importujte</translation>
    </message>
    <message>
        <source>There is no model to copy: import one first</source>
        <translation>Není model, který by se kopíroval: nejprve ho importujte</translation>
    </message>
    <message>
        <source>Drag to scatter copies, click for a single one. F: radius, Shift: take away, Ctrl: choose the model</source>
        <translation>Tažením rozmístíte kopie, klepnutím jednu. F: poloměr, Shift: odebrat, Ctrl: vybrat model</translation>
    </message>
    <message>
        <source>There is no terrain to draw on: import one first</source>
        <translation>Není terén, na který by se kreslilo: nejprve ho importujte</translation>
    </message>
    <message>
        <source>Click to add corners, drag to move them, Delete takes out the one under the pointer</source>
        <translation>Klepnutím přidáte rohy, tažením je posunete, Delete odebere ten pod ukazatelem</translation>
    </message>
    <message>
        <source>Click on the ground to begin the outline of a new avalanche release</source>
        <translation>Klepnutím na zem začnete obrys nového odtrhu laviny</translation>
    </message>
    <message>
        <source>Drag a handle. Ctrl: whole steps, Shift: up and down, Escape: take it back</source>
        <translation>Táhněte za úchyt. Ctrl: celé kroky, Shift: nahoru a dolů, Escape: vzít zpět</translation>
    </message>
    <message>
        <source>Select something that stands in the scene to get its handles</source>
        <translation>Vyberte něco, co stojí ve scéně, aby se ukázaly úchyty</translation>
    </message>
    <message>
        <source>Click to select. Middle button or Alt: turn, with Shift: shift the view, wheel: nearer</source>
        <translation>Klepnutím vyberete. Prostřední tlačítko nebo Alt: otáčet, se Shiftem: posouvat pohled, kolečko: blíž</translation>
    </message>
    <message>
        <source>Click on the model to copy</source>
        <translation>Klepněte na model, který se má kopírovat</translation>
    </message>
    <message>
        <source>Copies: %1</source>
        <translation>Kopie: %1</translation>
    </message>
    <message>
        <source>Copies: %1, no more are possible</source>
        <translation>Kopie: %1, více jich být nemůže</translation>
    </message>
    <message>
        <source>Drag a handle. Ctrl: whole steps, Escape: take it back</source>
        <translation>Táhněte za úchyt. Ctrl: celé kroky, Escape: vzít zpět</translation>
    </message>
    <message>
        <source>W: move, E: turn, R: scale, S: scatter copies of the selected model</source>
        <translation>W: posunout, E: otočit, R: zvětšit, S: rozmístit kopie vybraného modelu</translation>
    </message>
    <message>
        <source>B: paint the selected layer; the right button in the list of nodes fills and imports it</source>
        <translation>B: malovat vybranou vrstvu; pravé tlačítko v seznamu uzlů ji vyplní nebo importuje</translation>
    </message>
    <message>
        <source>Drag a corner or the middle. O: add and delete corners, B: paint the release</source>
        <translation>Táhněte za roh nebo za střed. O: přidávat a mazat rohy, B: malovat odtrh</translation>
    </message>
</context>
</TS>
