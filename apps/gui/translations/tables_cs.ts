<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="cs" sourcelanguage="en">
<context>
    <name>Settings</name>
    <message>
        <source>Image</source>
        <translation>Obraz</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Šířka</translation>
    </message>
    <message>
        <source>width of the image</source>
        <translation>šířka obrazu</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixelů</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>height of the image</source>
        <translation>výška obrazu</translation>
    </message>
    <message>
        <source>Anti-aliasing</source>
        <translation>Vyhlazování hran</translation>
    </message>
    <message>
        <source>N x N samples per pixel, averaged</source>
        <translation>průměr z N × N vzorků na pixel</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Rozmístění vzorků</translation>
    </message>
    <message>
        <source>positions of the samples in a pixel: rotated is best at edges, grid is fastest</source>
        <translation>kde v pixelu leží vzorky: rotated je nejlepší na hranách, grid je nejrychlejší</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Mřížka</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Náhodné</translation>
    </message>
    <message>
        <source>Jittered</source>
        <translation>Rozechvělá mřížka</translation>
    </message>
    <message>
        <source>Rotated</source>
        <translation>Otočené</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>Poissonovo</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>Přizpůsobivost</translation>
    </message>
    <message>
        <source>pixels that differ less from their neighbours get a quarter of the samples; off: all get all, 0.05: hard to see</source>
        <translation>pixely, které se od sousedů liší méně, dostanou čtvrtinu vzorků; vypnuto: všechny dostanou vše, 0.05: sotva viditelné</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Vypnuto</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Paprsky</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Stíny</translation>
    </message>
    <message>
        <source>lights cast shadows</source>
        <translation>světla vrhají stíny</translation>
    </message>
    <message>
        <source>Reflections</source>
        <translation>Odrazy</translation>
    </message>
    <message>
        <source>mirrors reflect</source>
        <translation>zrcadla odrážejí</translation>
    </message>
    <message>
        <source>Refractions</source>
        <translation>Lomy světla</translation>
    </message>
    <message>
        <source>transparent surfaces let light through</source>
        <translation>průhledné plochy propouštějí světlo</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Textury</translation>
    </message>
    <message>
        <source>textures are shown</source>
        <translation>textury jsou vidět</translation>
    </message>
    <message>
        <source>Max. bounces</source>
        <translation>Max. odrazů</translation>
    </message>
    <message>
        <source>most bounces by mirrors and glass</source>
        <translation>nejvíce odrazů a lomů na zrcadlech a skle</translation>
    </message>
    <message>
        <source>bounces</source>
        <translation>odrazů</translation>
    </message>
    <message>
        <source>Min. contribution</source>
        <translation>Nejmenší příspěvek</translation>
    </message>
    <message>
        <source>a ray that adds less than this fraction to its pixel is not traced</source>
        <translation>paprsek, který k pixelu přidá menší podíl, se nesleduje</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Zastínění okolím</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Zapnuto</translation>
    </message>
    <message>
        <source>corners are darker than open surfaces</source>
        <translation>kouty jsou tmavší než volné plochy</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Vzorky</translation>
    </message>
    <message>
        <source>rays per point for ambient occlusion</source>
        <translation>počet paprsků na jeden bod povrchu</translation>
    </message>
    <message>
        <source>rays</source>
        <translation>paprsků</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Vzdálenost</translation>
    </message>
    <message>
        <source>how far off a surface occludes; automatic: 15 % of the scene's diagonal</source>
        <translation>jak daleko plocha ještě stíní; automaticky: 15 % úhlopříčky scény</translation>
    </message>
    <message>
        <source>scene units</source>
        <translation>jednotek scény</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automaticky</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Vzor</translation>
    </message>
    <message>
        <source>directions of the rays, turned for each point, the same for all, or any</source>
        <translation>směry paprsků: pro každý bod pootočené, pro všechny stejné, nebo jakékoli</translation>
    </message>
    <message>
        <source>Regular</source>
        <translation>Pravidelné</translation>
    </message>
    <message>
        <source>Ambient light</source>
        <translation>Okolní světlo</translation>
    </message>
    <message>
        <source>ambient light; automatic: the scene's, or one that suits it when it has none</source>
        <translation>světlo odevšad; automaticky: podle scény, nebo co se k ní hodí, když žádné nemá</translation>
    </message>
    <message>
        <source>radiance</source>
        <translation>zář (radiance)</translation>
    </message>
    <message>
        <source>Sky light</source>
        <translation>Světlo oblohy</translation>
    </message>
    <message>
        <source>light surfaces from the sky or environment map, with shadows (image-based lighting); ambient light only with ambientOcclusion.on</source>
        <translation>osvětluje plochy oblohou nebo mapou prostředí, se stíny; okolní světlo jen s ambientOcclusion.on</translation>
    </message>
    <message>
        <source>rays per point for the light of the sky</source>
        <translation>počet paprsků na jeden bod povrchu pro světlo oblohy</translation>
    </message>
    <message>
        <source>Indirect</source>
        <translation>Nepřímé</translation>
    </message>
    <message>
        <source>Indirect light</source>
        <translation>Nepřímé světlo</translation>
    </message>
    <message>
        <source>light that surfaces send to each other, and that of the sky, learned while one walks; in place of ambient light, occlusion and skyLight; images by paths with denoise.net are mixed with one lit by it, and flicker less</source>
        <translation>světlo, které si plochy posílají navzájem, a světlo oblohy, zjišťované během chůze; místo okolního světla, zastínění a skyLight; obrázky pomocí drah s denoise.net se mísí s obrázkem, který je jím osvětlen, a méně blikají</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Živé</translation>
    </message>
    <message>
        <source>Path tracing</source>
        <translation>Sledování cest</translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation>Integrátor</translation>
    </message>
    <message>
        <source>whitted: mirrors, glass and light that comes straight; path: all light, also from surface to surface; only for stills</source>
        <translation>whitted: zrcadla, sklo a přímé světlo; path: veškeré světlo, i to od povrchu k povrchu; jen pro výsledné obrazy</translation>
    </message>
    <message>
        <source>Whitted ray tracing</source>
        <translation>Sledování paprsků (Whitted)</translation>
    </message>
    <message>
        <source>Samples per pixel</source>
        <translation>Vzorků na pixel</translation>
    </message>
    <message>
        <source>paths per pixel; 4 times as many halve the noise</source>
        <translation>počet cest na pixel; čtyřnásobek zmenší šum na polovinu</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>vzorků</translation>
    </message>
    <message>
        <source>most bounces of a path; 0: only light that comes straight</source>
        <translation>nejvíce odrazů jedné cesty; 0: jen přímé světlo</translation>
    </message>
    <message>
        <source>Roulette from bounce</source>
        <translation>Ruleta od odrazu</translation>
    </message>
    <message>
        <source>bounce from which weak paths may end by chance: less work, more noise, the same mean</source>
        <translation>od kolikátého odrazu mohou slabé cesty náhodně skončit: méně práce, více šumu, stejný průměr</translation>
    </message>
    <message>
        <source>Clamp indirect light</source>
        <translation>Omezit nepřímé světlo</translation>
    </message>
    <message>
        <source>most that a bounce after the first adds to a sample: fewer bright dots, but some light is lost</source>
        <translation>nejvíce, co odraz po prvním přidá ke vzorku: méně jasných teček, ale trochu světla se ztratí</translation>
    </message>
    <message>
        <source>Caustics</source>
        <translation>Kaustiky</translation>
    </message>
    <message>
        <source>light reaches surfaces by way of mirrors and glass, too: much more noise</source>
        <translation>světlo dopadá na povrchy i přes zrcadla a sklo: mnohem více šumu</translation>
    </message>
    <message>
        <source>Light from emission</source>
        <translation>Světlo ze svítících povrchů</translation>
    </message>
    <message>
        <source>surfaces that emit light others; automatic: unless lights stand in them</source>
        <translation>svítící povrchy osvětlují ostatní; automaticky: pokud v nich nestojí světla</translation>
    </message>
    <message>
        <source>Seed of the noise</source>
        <translation>Semínko šumu</translation>
    </message>
    <message>
        <source>another number gives other noise</source>
        <translation>jiné číslo dá jiný šum</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtr</translation>
    </message>
    <message>
        <source>of the filter that smooths noise of images by paths</source>
        <translation>průchody filtru, který vyhlazuje šum obrazů z cest</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>průchodů</translation>
    </message>
    <message>
        <source>Seed per frame</source>
        <translation>Semínko podle snímku</translation>
    </message>
    <message>
        <source>the number of a list's frame is added to the seed, so that noise does not stand still in a film</source>
        <translation>k semínku se přičte číslo snímku seznamu, aby šum ve filmu nestál</translation>
    </message>
    <message>
        <source>Depth of field</source>
        <translation>Hloubka ostrosti</translation>
    </message>
    <message>
        <source>only what is in focus is sharp</source>
        <translation>ostré je jen to, na co je zaostřeno</translation>
    </message>
    <message>
        <source>F number</source>
        <translation>Clonové číslo</translation>
    </message>
    <message>
        <source>focal length over the lens's diameter, of a film 36 mm wide: smaller is more blurred</source>
        <translation>ohnisková vzdálenost dělená průměrem čočky, pro film široký 36 mm: menší je rozmazanější</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Zaostření</translation>
    </message>
    <message>
        <source>distance of what is sharp; automatic: of what is in the middle</source>
        <translation>vzdálenost toho, co je ostré; automaticky: toho, co je uprostřed</translation>
    </message>
    <message>
        <source>Blades</source>
        <translation>Lamely</translation>
    </message>
    <message>
        <source>corners of the aperture; fewer than 3: round</source>
        <translation>počet rohů clony; méně než 3: kulatá</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Kulatá</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Mlha</translation>
    </message>
    <message>
        <source>the scene's fog is shown</source>
        <translation>mlha scény je vidět</translation>
    </message>
    <message>
        <source>Shafts</source>
        <translation>Kužely světla</translation>
    </message>
    <message>
        <source>shadow rays to each light along a ray through fog: shafts of light</source>
        <translation>stínové paprsky ke každému světlu podél paprsku mlhou: kužely světla</translation>
    </message>
    <message>
        <source>Area lights</source>
        <translation>Plošná světla</translation>
    </message>
    <message>
        <source>shadow rays to each area light: soft shadows; off: area lights are points</source>
        <translation>stínové paprsky ke každému plošnému světlu: měkké stíny; vypnuto: plošná světla jsou body</translation>
    </message>
    <message>
        <source>Denoise</source>
        <translation>Odšumění</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Průchody</translation>
    </message>
    <message>
        <source>smooths noise, but not edges</source>
        <translation>vyhladí šum, ale ne hrany</translation>
    </message>
    <message>
        <source>Net</source>
        <translation>Síť</translation>
    </message>
    <message>
        <source>a trained net takes the noise of paths away: small is quick, large is best; automatic: base where its weights are, else the filter, not for lists</source>
        <translation>naučená síť odstraní šum cest: small je rychlá, large nejlepší; automatic: base tam, kde jsou její váhy, jinak filtr, ne pro seznamy</translation>
    </message>
    <message>
        <source>Small</source>
        <translation>Malá</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Základní</translation>
    </message>
    <message>
        <source>Large</source>
        <translation>Velká</translation>
    </message>
    <message>
        <source>Mix</source>
        <translation>Míchání</translation>
    </message>
    <message>
        <source>the error of a net's image is estimated from 16 samples on, and from 64 on it is mixed with the sampled one: each where it has the smaller error</source>
        <translation>chyba obrazu ze sítě se odhaduje od 16 vzorků a od 64 se tento obraz mísí se vzorkovaným: každý tam, kde má menší chybu</translation>
    </message>
    <message>
        <source>Bloom</source>
        <translation>Záře</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Poloměr</translation>
    </message>
    <message>
        <source>size of the bloom around bright spots</source>
        <translation>velikost záře kolem jasných míst</translation>
    </message>
    <message>
        <source>Kernel</source>
        <translation>Tvar</translation>
    </message>
    <message>
        <source>blur of a plain lens, or the coloured rings of a perfect one</source>
        <translation>rozmazání obyčejné čočky, nebo barevné kroužky dokonalé</translation>
    </message>
    <message>
        <source>Gaussian</source>
        <translation>Gaussův</translation>
    </message>
    <message>
        <source>Airy</source>
        <translation>Airyho</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Podíl</translation>
    </message>
    <message>
        <source>fraction of all light that bloom spreads</source>
        <translation>jaký podíl všeho světla záře rozptýlí</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Expozice</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Režim</translation>
    </message>
    <message>
        <source>automatic follows the image's brightness, incident the light on what is seen: a white room stays white, a black car black</source>
        <translation>automatický se řídí jasem obrazu, podle dopadu světlem na tom, co je vidět: bílý pokoj zůstane bílý, černé auto černé</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Pevný</translation>
    </message>
    <message>
        <source>Incident</source>
        <translation>Podle dopadu</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Hodnota</translation>
    </message>
    <message>
        <source>fixed exposure: radiance that is shown as half of white</source>
        <translation>pevná expozice: zář, která se ukáže jako polovina bílé</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Klíč</translation>
    </message>
    <message>
        <source>exposure that is not fixed: larger is brighter</source>
        <translation>expozice, která není pevná: větší je světlejší</translation>
    </message>
    <message>
        <source>Brighter seconds</source>
        <translation>Přivykání světlu</translation>
    </message>
    <message>
        <source>time to get used to more light, in real time</source>
        <translation>doba, za kterou si oko zvykne na více světla v reálném čase</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Darker seconds</source>
        <translation>Přivykání tmě</translation>
    </message>
    <message>
        <source>time to get used to less light, in real time</source>
        <translation>doba, za kterou si oko zvykne na méně světla v reálném čase</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>Místní</translation>
    </message>
    <message>
        <source>how much the exposure of a region follows its own brightness</source>
        <translation>jak moc se expozice místa řídí jeho vlastním jasem</translation>
    </message>
    <message>
        <source>Recorded exposures</source>
        <translation>Zaznamenané expozice</translation>
    </message>
    <message>
        <source>exposures of .cam files in stills; scaled: brighter light of paths looks as bright as recorded, by the list's first frame; automatic: measured anew</source>
        <translation>expozice ze souborů .cam při vykreslování; přepočtená: jasnější světlo cest vypadá stejně jasně jako v záznamu, podle prvního snímku seznamu; automatická: změří se znovu</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>Přepočtená</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Přesná</translation>
    </message>
    <message>
        <source>Tone mapping</source>
        <translation>Mapování tónů</translation>
    </message>
    <message>
        <source>luminance keeps hues, channels lets bright colours fade to white, agx is like film, neutral keeps all but the brightest colours</source>
        <translation>podle jasu zůstávají odstíny, po složkách jasné barvy blednou do bílé, AgX je jako film, neutrální zachovává všechny barvy kromě nejjasnějších</translation>
    </message>
    <message>
        <source>Luminance</source>
        <translation>Podle jasu</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Po složkách</translation>
    </message>
    <message>
        <source>AgX</source>
        <translation>AgX</translation>
    </message>
    <message>
        <source>Neutral</source>
        <translation>Neutrální</translation>
    </message>
    <message>
        <source>Tone contrast</source>
        <translation>Kontrast tónů</translation>
    </message>
    <message>
        <source>contrast and colour of agx: 0 as soft as film, 1 punchy, and beyond</source>
        <translation>kontrast a barevnost AgX: 0 měkký jako film, 1 výrazný, i více</translation>
    </message>
    <message>
        <source>Dithering</source>
        <translation>Dithering</translation>
    </message>
    <message>
        <source>noise of less than one step hides bands in smooth gradients</source>
        <translation>šum menší než jeden stupeň skryje pruhy v plynulých přechodech</translation>
    </message>
    <message>
        <source>False colours</source>
        <translation>Nepravé barvy</translation>
    </message>
    <message>
        <source>light is shown by the colours of a scale, dark to bright, in place of the image; without bloom and local exposure</source>
        <translation>místo obrazu se ukáže světlo barvami stupnice, od tmavé po světlou; bez záře a místní expozice</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Veličina</translation>
    </message>
    <message>
        <source>luminance is how bright things look, in cd/m2; illuminance how much light arrives at the surface that is seen first, in lux</source>
        <translation>jas je, jak světlé věci se jeví, v cd/m²; osvětlenost, kolik světla dopadá na plochu, která je vidět první, v luxech</translation>
    </message>
    <message>
        <source>Illuminance</source>
        <translation>Osvětlenost</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Od</translation>
    </message>
    <message>
        <source>lower end of the scale; automatic: by what is seen</source>
        <translation>dolní konec stupnice; automaticky: podle toho, co je vidět</translation>
    </message>
    <message>
        <source>cd/m2 or lux</source>
        <translation>cd/m² nebo lx</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Do</translation>
    </message>
    <message>
        <source>upper end of the scale; automatic: by what is seen</source>
        <translation>horní konec stupnice; automaticky: podle toho, co je vidět</translation>
    </message>
    <message>
        <source>Isolines</source>
        <translation>Izočáry</translation>
    </message>
    <message>
        <source>lines of equal light at 1, 2, 5, 10, 20 and so on</source>
        <translation>čáry stejného světla u 1, 2, 5, 10, 20 a tak dále</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legenda</translation>
    </message>
    <message>
        <source>the scale is painted into the image</source>
        <translation>stupnice se namaluje do obrazu</translation>
    </message>
    <message>
        <source>Environment filter</source>
        <translation>Filtr prostředí</translation>
    </message>
    <message>
        <source>lookup in environment maps</source>
        <translation>čtení z map prostředí</translation>
    </message>
    <message>
        <source>Bilinear</source>
        <translation>Bilineární</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>Nejbližší</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Jas</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Hrubá</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Dobrá</translation>
    </message>
    <message>
        <source>Final</source>
        <translation>Konečná</translation>
    </message>
</context>
<context>
    <name>Edits</name>
    <message>
        <source>setting</source>
        <translation>nastavení</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>výchozí hodnoty</translation>
    </message>
    <message>
        <source>quality</source>
        <translation>kvalita</translation>
    </message>
    <message>
        <source>look there</source>
        <translation>pohled na místo</translation>
    </message>
    <message>
        <source>reset camera</source>
        <translation>výchozí kamera</translation>
    </message>
    <message>
        <source>paste camera</source>
        <translation>vložit kameru</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>úhel záběru</translation>
    </message>
    <message>
        <source>up axis</source>
        <translation>směr vzhůru</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>jednotka</translation>
    </message>
    <message>
        <source>focus there</source>
        <translation>zaostřit na místo</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>kamera</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>nastavení</translation>
    </message>
    <message>
        <source>bloom</source>
        <translation>záře</translation>
    </message>
    <message>
        <source>light</source>
        <translation>světlo</translation>
    </message>
    <message>
        <source>add light</source>
        <translation>přidat světlo</translation>
    </message>
    <message>
        <source>copy light</source>
        <translation>kopírovat světlo</translation>
    </message>
    <message>
        <source>remove light</source>
        <translation>odebrat světlo</translation>
    </message>
    <message>
        <source>move light</source>
        <translation>přesunout světlo</translation>
    </message>
    <message>
        <source>turn light</source>
        <translation>natočit světlo</translation>
    </message>
    <message>
        <source>colour of light</source>
        <translation>barva světla</translation>
    </message>
    <message>
        <source>temperature of light</source>
        <translation>teplota světla</translation>
    </message>
    <message>
        <source>power of light</source>
        <translation>výkon světla</translation>
    </message>
    <message>
        <source>kind of light</source>
        <translation>druh světla</translation>
    </message>
    <message>
        <source>size of light</source>
        <translation>velikost světla</translation>
    </message>
    <message>
        <source>angles of light</source>
        <translation>úhly světla</translation>
    </message>
    <message>
        <source>light in mirrors</source>
        <translation>světlo v zrcadlech</translation>
    </message>
    <message>
        <source>file of light</source>
        <translation>soubor světla</translation>
    </message>
    <message>
        <source>name of light</source>
        <translation>název světla</translation>
    </message>
    <message>
        <source>environment</source>
        <translation>prostředí</translation>
    </message>
    <message>
        <source>sky</source>
        <translation>obloha</translation>
    </message>
    <message>
        <source>light of the scene</source>
        <translation>osvětlení scény</translation>
    </message>
    <message>
        <source>bookmark</source>
        <translation>záložka</translation>
    </message>
    <message>
        <source>material</source>
        <translation>materiál</translation>
    </message>
    <message>
        <source>visible parts</source>
        <translation>viditelné části</translation>
    </message>
    <message>
        <source>section</source>
        <translation>řez</translation>
    </message>
    <message>
        <source>measure</source>
        <translation>míra</translation>
    </message>
    <message>
        <source>note</source>
        <translation>poznámka</translation>
    </message>
    <message>
        <source>flight</source>
        <translation>let</translation>
    </message>
    <message>
        <source>variant</source>
        <translation>varianta</translation>
    </message>
</context>
<context>
    <name>LightKinds</name>
    <message>
        <source>Point</source>
        <translation>Bodové</translation>
    </message>
    <message>
        <source>Directional</source>
        <translation>Směrové</translation>
    </message>
    <message>
        <source>Spot</source>
        <translation>Kuželové</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Koule</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Obdélník</translation>
    </message>
    <message>
        <source>Luminaire</source>
        <translation>Svítidlo IES</translation>
    </message>
</context>
<context>
    <name>ProgramOptions</name>
    <message>
        <source>Output</source>
        <translation>Výstup</translation>
    </message>
    <message>
        <source>write the image there; the extension says the format; .exr, .hdr and .pfm hold linear radiance, not tone mapped; '-' is standard output; may be given several times [the scene's output, else its name with .png in the current folder]</source>
        <translation>sem se obraz zapíše; přípona určuje formát; .exr, .hdr a .pfm obsahují lineární zář bez mapování tónů; '-' je standardní výstup; lze zadat vícekrát [výstup podle scény, jinak její jméno s .png v aktuální složce]</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formát</translation>
    </message>
    <message>
        <source>format of the image on standard output: png or ppm [png]</source>
        <translation>formát obrazu na standardním výstupu: png nebo ppm [png]</translation>
    </message>
    <message>
        <source>AOVs</source>
        <translation>Vrstvy AOV</translation>
    </message>
    <message>
        <source>outputs with the extension .exr also hold AOVs: depth, normal, albedo, direct light and ambient occlusion of the surfaces</source>
        <translation>výstupy s příponou .exr obsahují také vrstvy AOV: hloubku, normálu, odrazivost, přímé světlo a zastínění povrchů okolím</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Průhlednost</translation>
    </message>
    <message>
        <source>leave the background out: outputs are transparent there; .png, .tif, .tga, .webp and .exr can hold that</source>
        <translation>vynechat pozadí: výstupy jsou tam průhledné; umějí to .png, .tif, .tga, .webp a .exr</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>Podklad</translation>
    </message>
    <message>
        <source>show this in place of the background: a colour #rrggbb, two of them for a gradient from top to bottom (#rrggbb,#rrggbb), or an image file</source>
        <translation>ukázat místo pozadí toto: barvu #rrggbb, dvě pro přechod shora dolů (#rrggbb,#rrggbb), nebo soubor s obrazem</translation>
    </message>
    <message>
        <source>Ground shadow</source>
        <translation>Stín na zemi</translation>
    </message>
    <message>
        <source>with --alpha or --backdrop: the model casts its shadow on a ground below it that is not seen itself</source>
        <translation>s --alpha nebo --backdrop: model vrhá stín na zem pod sebou, která sama není vidět</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Šířka</translation>
    </message>
    <message>
        <source>pixels from left to right; alone it keeps the aspect</source>
        <translation>počet pixelů zleva doprava; sám zachová poměr stran</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>pixels from top to bottom; alone it keeps the aspect</source>
        <translation>počet pixelů shora dolů; sám zachová poměr stran</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Rozměr</translation>
    </message>
    <message>
        <source>width and height at once: hd, fullhd, qhd, 4k, 8k, a4 ... a0 or 1200x800</source>
        <translation>šířka a výška najednou: hd, fullhd, qhd, 4k, 8k, a4 ... a0 nebo 1200x800</translation>
    </message>
    <message>
        <source>Panorama</source>
        <translation>Panorama</translation>
    </message>
    <message>
        <source>an image all around the eye, equirectangular, N x N/2 pixels; what the camera looks at is in its middle, and the horizon is level</source>
        <translation>obraz všeho kolem oka v ekvirektangulární projekci, N x N/2 pixelů; uprostřed je to, nač kamera hledí, a obzor je vodorovný</translation>
    </message>
    <message>
        <source>View and video</source>
        <translation>Pohled a film</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>look through this .cam file</source>
        <translation>pohled podle tohoto souboru .cam</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>take this model or .bsp in place of the one that the .scn names</source>
        <translation>použít tento model nebo .bsp místo toho, který uvádí .scn</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Varianta</translation>
    </message>
    <message>
        <source>show this variant of the .scn; all: each in turn, with its name in the names of the outputs; none: the scene without one</source>
        <translation>zobrazit tuto variantu souboru .scn; all: jednu po druhé, se jménem ve jménech výstupů; none: scénu bez varianty</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Seznam</translation>
    </message>
    <message>
        <source>render a frame for each .cam file that this text file lists; #### in the output's name becomes the number of the frame, from 0001</source>
        <translation>vykreslit snímek pro každý soubor .cam z tohoto textového seznamu; #### ve jménu výstupu se nahradí číslem snímku od 0001</translation>
    </message>
    <message>
        <source>Flight</source>
        <translation>Let</translation>
    </message>
    <message>
        <source>render the frames of a flight that the .scn keeps, as those of a list</source>
        <translation>vykreslit snímky letu, který uchovává .scn, jako snímky seznamu</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Otočný stůl</translation>
    </message>
    <message>
        <source>go once around the model in S seconds, from the scene's view or that of --camera on, as by a flight</source>
        <translation>obejít model jednou za S sekund, od pohledu scény nebo od --camera, jako letem</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Otáčky</translation>
    </message>
    <message>
        <source>with --turntable: so many times around; below 0 it goes clockwise, as seen from above [1]</source>
        <translation>s --turntable: tolikrát dokola; pod 0 po směru hodinových ručiček při pohledu shora [1]</translation>
    </message>
    <message>
        <source>Make list</source>
        <translation>Zapsat seznam</translation>
    </message>
    <message>
        <source>render nothing; write the cameras of the flight or the turntable as a list of .cam files, in a folder beside it</source>
        <translation>nic nevykreslit; zapsat kamery letu nebo otočného stolu jako seznam souborů .cam ve složce vedle něj</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Snímky</translation>
    </message>
    <message>
        <source>render only these frames of the list or flight; also A, A- and -B</source>
        <translation>vykreslit jen tyto snímky seznamu nebo letu; také A, A- a -B</translation>
    </message>
    <message>
        <source>Chunk</source>
        <translation>Díl</translation>
    </message>
    <message>
        <source>render the I-th of N equal parts of the list or flight, or of --frames</source>
        <translation>vykreslit I-tou z N stejných částí seznamu nebo letu, nebo z --frames</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Znovu i hotové</translation>
    </message>
    <message>
        <source>render frames again whose files are there already and whole; they are skipped otherwise</source>
        <translation>vykreslit znovu i snímky, jejichž soubory už jsou hotové a celé; jinak se přeskočí</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Jen ověřit</translation>
    </message>
    <message>
        <source>render nothing; list the frames whose files are missing or broken, and exit with 1 if there are any</source>
        <translation>nic nevykreslovat; vypsat snímky, jejichž soubory chybějí nebo jsou poškozené, a pokud nějaké jsou, skončit s kódem 1</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Sledovat zápis</translation>
    </message>
    <message>
        <source>the list is still being written: wait for more frames until the line '# end' comes</source>
        <translation>seznam se ještě zapisuje: čekat na další snímky, dokud nepřijde řádek '# end'</translation>
    </message>
    <message>
        <source>Follow timeout</source>
        <translation>Čekat nejdéle</translation>
    </message>
    <message>
        <source>with --follow: take the list as complete when no frame came for S seconds [60]</source>
        <translation>s --follow: považovat seznam za úplný, když S sekund nepřišel žádný snímek [60]</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>make a film of the list or flight by ffmpeg: .mp4, .webm, .mkv, .gif; with -o the frames are kept as well, and those that are there are used</source>
        <translation>udělat ze seznamu nebo letu film pomocí ffmpeg: .mp4, .webm, .mkv, .gif; s -o zůstanou i snímky a použijí se ty, které už jsou</translation>
    </message>
    <message>
        <source>FPS</source>
        <translation>Snímků za sekundu</translation>
    </message>
    <message>
        <source>frames per second of the film or flight [as the .cam files were recorded, else 25]</source>
        <translation>snímků za sekundu filmu nebo letu [jak byly nahrány soubory .cam, jinak 25]</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Kvalita</translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation>Integrátor</translation>
    </message>
    <message>
        <source>whitted: mirrors, glass and light that comes straight; path: all light, also from surface to surface [whitted]</source>
        <translation>whitted: zrcadla, sklo a přímé světlo; path: veškeré světlo, i to od povrchu k povrchu [whitted]</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Vzorky</translation>
    </message>
    <message>
        <source>with --integrator=path: N paths per pixel [256]</source>
        <translation>s --integrator=path: N cest na pixel [256]</translation>
    </message>
    <message>
        <source>Denoise</source>
        <translation>Odstranit šum</translation>
    </message>
    <message>
        <source>with --integrator=path: a trained net takes the noise away: small, base, large or automatic [off]; base@DIGEST only by weights whose SHA-256 begins so</source>
        <translation>s --integrator=path: šum odstraní naučená síť: small, base, large nebo automatic [off]; base@OTISK jen s vahami, jejichž SHA-256 takto začíná</translation>
    </message>
    <message>
        <source>Nets</source>
        <translation>Sítě</translation>
    </message>
    <message>
        <source>the folder of the nets' weights [RT_NETS, else where rtsuite-fetch-nets puts them]</source>
        <translation>složka s váhami sítí [RT_NETS, jinak kam je dá rtsuite-fetch-nets]</translation>
    </message>
    <message>
        <source>Antialiasing</source>
        <translation>Vyhlazování hran</translation>
    </message>
    <message>
        <source>N x N samples per pixel</source>
        <translation>N × N vzorků na pixel</translation>
    </message>
    <message>
        <source>Bloom</source>
        <translation>Záře</translation>
    </message>
    <message>
        <source>bloom around bright spots: a blur of N pixels (standard deviation); 0 is none</source>
        <translation>záře kolem jasných míst: rozostření o N pixelech (směrodatná odchylka); 0 je žádná</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Zastínění okolím</translation>
    </message>
    <message>
        <source>switch ambient occlusion on: corners are darker than open surfaces</source>
        <translation>zapnout zastínění okolím: kouty jsou tmavší než volné plochy</translation>
    </message>
    <message>
        <source>No ambient occlusion</source>
        <translation>Bez zastínění okolím</translation>
    </message>
    <message>
        <source>switch ambient occlusion off</source>
        <translation>vypnout zastínění okolím</translation>
    </message>
    <message>
        <source>AO samples</source>
        <translation>Paprsky zastínění</translation>
    </message>
    <message>
        <source>switch ambient occlusion on, with N rays per point</source>
        <translation>zapnout zastínění okolím s N paprsky na bod povrchu</translation>
    </message>
    <message>
        <source>AO distance</source>
        <translation>Dosah zastínění</translation>
    </message>
    <message>
        <source>switch ambient occlusion on, up to this distance</source>
        <translation>zapnout zastínění okolím až do této vzdálenosti</translation>
    </message>
    <message>
        <source>Focus at</source>
        <translation>Zaostřit na</translation>
    </message>
    <message>
        <source>switch depth of field on, focused on what is seen at this pixel</source>
        <translation>zapnout hloubku ostrosti se zaostřením na to, co je vidět v tomto pixelu</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Expozice</translation>
    </message>
    <message>
        <source>fixed exposure: a luminance of C becomes half of the display's range [automatic]</source>
        <translation>pevná expozice: jas C se ukáže v polovině rozsahu displeje [automaticky]</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Soubor nastavení</translation>
    </message>
    <message>
        <source>take settings from the table [still] of this .set file</source>
        <translation>převzít nastavení z tabulky [still] tohoto souboru .set</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <source>any setting by its name; may be given several times</source>
        <translation>libovolné nastavení podle jména; lze zadat vícekrát</translation>
    </message>
    <message>
        <source>Kept light</source>
        <translation>Uchované světlo</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Světlo</translation>
    </message>
    <message>
        <source>with indirect.mode=live: images begin with the indirect light of this file, so that they come sooner and those of a list do not flicker [a list learns it of its views]</source>
        <translation>při indirect.mode=live: obrázky začínají nepřímým světlem z tohoto souboru, takže jsou hotové dříve a snímky seznamu neblikají [seznam je zjistí ze svých pohledů]</translation>
    </message>
    <message>
        <source>Make light</source>
        <translation>Vytvořit světlo</translation>
    </message>
    <message>
        <source>learn indirect light, write it to this .light file, and exit: that of the views of a list, of one camera, or of views from all over the floors</source>
        <translation>zjistit nepřímé světlo, zapsat je do tohoto souboru .light a skončit: světlo pohledů seznamu, jedné kamery nebo pohledů ze všech podlah</translation>
    </message>
    <message>
        <source>Light time</source>
        <translation>Čas pro světlo</translation>
    </message>
    <message>
        <source>with --make-light: learn for S seconds at most, about [no bound]</source>
        <translation>s --make-light: zjišťovat přibližně nejvýše S sekund [bez omezení]</translation>
    </message>
    <message>
        <source>Light size</source>
        <translation>Velikost světla</translation>
    </message>
    <message>
        <source>with --make-light: learn no more once the file has so many megabytes [no bound]</source>
        <translation>s --make-light: dál nezjišťovat, jakmile má soubor tolik megabajtů [bez omezení]</translation>
    </message>
    <message>
        <source>Plans</source>
        <translation>Plány</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plán</translation>
    </message>
    <message>
        <source>draw a plan to scale, write it to this .svg, .pdf, .dxf, .png or .tif file, and exit: what is cut, visible edges beyond, and the areas of rooms</source>
        <translation>nakreslit plán v měřítku, zapsat jej do tohoto souboru .svg, .pdf, .dxf, .png nebo .tif a skončit: co je rozříznuto, viditelné hrany za řezem a plochy místností</translation>
    </message>
    <message>
        <source>Plan from</source>
        <translation>Plán odkud</translation>
    </message>
    <message>
        <source>with --plan: above, a plan of a storey; front, back, left or right, an elevation; section, what the scene's section leaves [above]</source>
        <translation>s --plan: above, půdorys podlaží; front, back, left nebo right, pohled; section, co zbude z řezu scény [above]</translation>
    </message>
    <message>
        <source>Plan storey</source>
        <translation>Plán: podlaží</translation>
    </message>
    <message>
        <source>with --plan: the N-th storey from below [that of a camera indoors, else the lowest]</source>
        <translation>s --plan: N-té podlaží odspoda [to, v němž je kamera uvnitř, jinak nejnižší]</translation>
    </message>
    <message>
        <source>Plan floor</source>
        <translation>Plán: podlaha</translation>
    </message>
    <message>
        <source>with --plan: a floor at M metres, in the coordinates of the model's file, in place of a storey that is found</source>
        <translation>s --plan: podlaha ve výšce M metrů v souřadnicích souboru modelu namísto nalezeného podlaží</translation>
    </message>
    <message>
        <source>Plan height</source>
        <translation>Plán: výška</translation>
    </message>
    <message>
        <source>with --plan: cut M metres above the floor [1.2]</source>
        <translation>s --plan: řez M metrů nad podlahou [1,2]</translation>
    </message>
    <message>
        <source>Plan scale</source>
        <translation>Plán: měřítko</translation>
    </message>
    <message>
        <source>with --plan: 1 to N [100]</source>
        <translation>s --plan: 1 ku N [100]</translation>
    </message>
    <message>
        <source>Plan paper</source>
        <translation>Plán: papír</translation>
    </message>
    <message>
        <source>with --plan: A4, A3, A2, A1 or A0, lying; a .pdf takes as many sheets as it needs, a .png or .tif as many files [one as large as it must be]</source>
        <translation>s --plan: A4, A3, A2, A1 nebo A0 naležato; .pdf má tolik listů, kolik potřebuje, .png nebo .tif tolik souborů [jeden tak velký, jak je třeba]</translation>
    </message>
    <message>
        <source>Plan dpi</source>
        <translation>Rozlišení plánu</translation>
    </message>
    <message>
        <source>with --plan: pixels of a .png or .tif to an inch of paper [300]</source>
        <translation>s --plan: pixely .png nebo .tif na palec papíru [300]</translation>
    </message>
    <message>
        <source>Plan image</source>
        <translation>Obrázek plánu</translation>
    </message>
    <message>
        <source>with --plan: what a .png or .tif has: lines, the rendered light of what they show, or both, lines over light [lines]</source>
        <translation>s --plan: co je v .png nebo .tif: čáry, vykreslené světlo toho, co ukazují, nebo obojí, čáry přes světlo [lines]</translation>
    </message>
    <message>
        <source>Plan door</source>
        <translation>Plán: dveře</translation>
    </message>
    <message>
        <source>with --plan: openings of up to M metres part rooms, wider ones join them [1.2]</source>
        <translation>s --plan: otvory do M metrů dělí místnosti, širší je spojují [1,2]</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Náhled</translation>
    </message>
    <message>
        <source>show the image while it is rendered, from coarse to fine, to programs that look for an instance of this name; without --output no file is written; stops with the process that started it</source>
        <translation>ukazovat obraz během vykreslování, od hrubého k jemnému, programům, které hledají instanci tohoto jména; bez --output se nezapíše žádný soubor; skončí s procesem, který jej spustil</translation>
    </message>
    <message>
        <source>Run ID</source>
        <translation>Číslo běhu</translation>
    </message>
    <message>
        <source>mark the frames of the preview with N, so that viewers can tell runs apart [0]</source>
        <translation>označit snímky náhledu číslem N, aby se běhy daly rozlišit [0]</translation>
    </message>
    <message>
        <source>Linger</source>
        <translation>Doznívání</translation>
    </message>
    <message>
        <source>seconds for which the last frame of the preview can be found [2]</source>
        <translation>kolik sekund lze najít poslední snímek náhledu [2]</translation>
    </message>
    <message>
        <source>Stand by</source>
        <translation>Pohotovost</translation>
    </message>
    <message>
        <source>after that image, show those that lines on standard input ask for, until it ends</source>
        <translation>po tomto obrázku ukazovat ty, o které žádají řádky na standardním vstupu, dokud neskončí</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Běh</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Vlákna</translation>
    </message>
    <message>
        <source>use N threads; 0 is all cores; the results are the same for every number [0]</source>
        <translation>použít N vláken; 0 jsou všechna jádra; výsledky jsou pro každý počet stejné [0]</translation>
    </message>
    <message>
        <source>ISA</source>
        <translation>Instrukční sada</translation>
    </message>
    <message>
        <source>use the vector code of one instruction set, of those that --version lists; the results are the same [auto]</source>
        <translation>použít vektorový kód jedné instrukční sady z těch, které vypíše --version; výsledky jsou stejné [auto]</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Průběh</translation>
    </message>
    <message>
        <source>how progress is shown on stderr: bar, plain (lines), json (one object a line), none, or auto (bar on a terminal, else plain) [auto]</source>
        <translation>jak se na stderr ukazuje průběh: bar (pruh), plain (řádky), json (objekt na řádek), none (nijak), nebo auto (v terminálu bar, jinak plain) [auto]</translation>
    </message>
    <message>
        <source>Parent</source>
        <translation>Rodič</translation>
    </message>
    <message>
        <source>stop as soon as this process, which started the program, is no more</source>
        <translation>skončit, jakmile neběží tento proces, který program spustil</translation>
    </message>
    <message>
        <source>Requeue</source>
        <translation>Znovu do fronty</translation>
    </message>
    <message>
        <source>exit with 75 (try again), not 143, when SIGTERM stops the run, so that a batch system sends the job again</source>
        <translation>když běh zastaví SIGTERM, skončit s kódem 75 (zkusit znovu), ne 143, aby dávkový systém úlohu poslal znovu</translation>
    </message>
    <message>
        <source>Verbose</source>
        <translation>Podrobně</translation>
    </message>
    <message>
        <source>report times and rays on stderr</source>
        <translation>vypsat na stderr časy a počty paprsků</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Zpráva</translation>
    </message>
    <message>
        <source>write a report of the images as JSON: times, rays, settings, what a net did and the error that is left</source>
        <translation>zapsat zprávu o obrazech ve formátu JSON: časy, paprsky, nastavení, co udělala síť a jaká chyba zbývá</translation>
    </message>
    <message>
        <source>Debug scene</source>
        <translation>Ladicí scéna</translation>
    </message>
    <message>
        <source>write what the renderer works with - cells of the kd-tree, lights, camera, normals - as an .obj model, and exit</source>
        <translation>zapsat, s čím vykreslování pracuje – buňky kd-stromu, světla, kameru, normály – jako model .obj, a skončit</translation>
    </message>
    <message>
        <source>Surroundings</source>
        <translation>Okolí</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Mapa prostředí</translation>
    </message>
    <message>
        <source>show this environment map and let it light the scene: a sphere, a cross or a strip</source>
        <translation>zobrazí tuto mapu prostředí, která osvětlí scénu: kouli, kříž nebo pás</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Obloha</translation>
    </message>
    <message>
        <source>show a computed sky with a sun: the hour, or the keys of a scene's [sky], parted by commas, such as 'hour=17,latitude=48.2,turbidity=4'</source>
        <translation>zobrazí vypočtenou oblohu se sluncem: hodina, nebo klíče [sky] scény oddělené čárkami, například 'hour=17,latitude=48.2,turbidity=4'</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Osvětlení</translation>
    </message>
    <message>
        <source>what lights the scene in place of its own lights: sky, studio or headlight</source>
        <translation>čím je scéna osvětlena namísto vlastních světel: sky, studio nebo headlight</translation>
    </message>
    <message>
        <source>Parts, sections and lights</source>
        <translation>Části, řezy a světla</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Pouze část</translation>
    </message>
    <message>
        <source>show this part of the model alone; given several times, these</source>
        <translation>zobrazí z modelu pouze tuto část; při opakování pouze tyto části</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Skrýt část</translation>
    </message>
    <message>
        <source>leave this part of the model out; may be given several times</source>
        <translation>vynechá tuto část modelu; lze opakovat</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zobrazit část</translation>
    </message>
    <message>
        <source>show this part of the model where the scene hides it; may be given several times</source>
        <translation>zobrazí tuto část modelu, i když ji scéna skrývá; lze opakovat</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Řez</translation>
    </message>
    <message>
        <source>cut the model open: take away what lies beyond the point, along the normal; may be given six times</source>
        <translation>rozříznout model: odebrat, co leží za bodem ve směru normály; lze uvést šestkrát</translation>
    </message>
    <message>
        <source>Section box</source>
        <translation>Kvádr řezu</translation>
    </message>
    <message>
        <source>leave what is in the box between these corners</source>
        <translation>ponechat, co je v kvádru mezi těmito rohy</translation>
    </message>
    <message>
        <source>Section except</source>
        <translation>Řez kromě</translation>
    </message>
    <message>
        <source>leave this part of the model whole, whatever is cut; may be given several times</source>
        <translation>ponechat tuto část modelu celou, ať se řeže cokoli; lze zadat vícekrát</translation>
    </message>
    <message>
        <source>Section light</source>
        <translation>Světlo v řezu</translation>
    </message>
    <message>
        <source>whole: the rooms of what is cut keep their light, as if nothing was cut; cut: light falls in [whole]</source>
        <translation>whole: rozříznuté místnosti si ponechají světlo, jako by se nic neřízlo; cut: světlo dopadá dovnitř [whole]</translation>
    </message>
    <message>
        <source>Section caps</source>
        <translation>Plochy řezu</translation>
    </message>
    <message>
        <source>close solids that are cut: own: in the colours of their materials; one: all in the scene's sectionColour; none: one looks into them [own]</source>
        <translation>uzavře proříznutá tělesa: own: v barvách jejich materiálů; one: všechna v barvě sectionColour scény; none: je vidět do nich [own]</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Světla</translation>
    </message>
    <message>
        <source>switch these lights on and all others off: names and numbers, parted by commas; all; none</source>
        <translation>zapne tato světla a všechna ostatní vypne: názvy a čísla oddělené čárkami; all (všechna); none (žádné)</translation>
    </message>
    <message>
        <source>Importing models</source>
        <translation>Import modelů</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Směr vzhůru</translation>
    </message>
    <message>
        <source>the model's axis that is up [auto: what its file says, else a guess]</source>
        <translation>osa modelu, která míří vzhůru [auto: co říká soubor, jinak odhad]</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Jednotky</translation>
    </message>
    <message>
        <source>the model's unit: mm, cm, m, in, ft or metres per unit [auto]</source>
        <translation>jednotka modelu: mm, cm, m, in, ft nebo počet metrů na jednotku [auto]</translation>
    </message>
    <message>
        <source>Crease angle</source>
        <translation>Úhel hrany</translation>
    </message>
    <message>
        <source>where the file has no normals, edges sharper than this stay sharp [40]</source>
        <translation>kde soubor nemá normály, zůstanou hrany ostřejší než tento úhel ostré [40]</translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation>Odchylka</translation>
    </message>
    <message>
        <source>how far triangles may lie off the surfaces of CAD files, as a fraction of the model's diagonal [0.0005]</source>
        <translation>jak daleko smějí trojúhelníky ležet od ploch souborů CAD, jako zlomek úhlopříčky modelu [0.0005]</translation>
    </message>
    <message>
        <source>Flip textures</source>
        <translation>Převrátit textury</translation>
    </message>
    <message>
        <source>turn textures upside down: some exporters count from the top</source>
        <translation>převrátit textury vzhůru nohama: některé exportéry počítají shora</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Póza</translation>
    </message>
    <message>
        <source>rest, first or NAME@SECONDS of a model with animations [rest]</source>
        <translation>rest, first nebo NÁZEV@SEKUNDY modelu s animacemi [rest]</translation>
    </message>
    <message>
        <source>Memory limit</source>
        <translation>Mez paměti</translation>
    </message>
    <message>
        <source>memory that importing may take [half of the machine's]</source>
        <translation>paměť, kterou smí import použít [polovina paměti počítače]</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Mez času</translation>
    </message>
    <message>
        <source>seconds that one step of importing may take [15, and 2 more for each MB of the file; 5 for a tiny one]</source>
        <translation>kolik sekund smí trvat jeden krok importu [15 a 2 navíc za každý MB souboru; u malého 5]</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Rychlá stavba</translation>
    </message>
    <message>
        <source>build in less than half the time; the tree is about a sixth slower to trace</source>
        <translation>stavět za méně než polovinu času; sledování paprsků je pak asi o šestinu pomalejší</translation>
    </message>
    <message>
        <source>with --fast (1 to 4 are alike): 1 is quickest to build, 10 quickest to trace [5]</source>
        <translation>s --fast (1 až 4 jsou stejné): 1 se nejrychleji staví, 10 se nejrychleji sleduje [5]</translation>
    </message>
    <message>
        <source>report the model and times on standard output</source>
        <translation>vypsat na standardní výstup model a časy</translation>
    </message>
    <message>
        <source>Very verbose</source>
        <translation>Velmi podrobně</translation>
    </message>
    <message>
        <source>report also the tree, the time of each phase, and whether the tree passes every check</source>
        <translation>vypsat také strom, čas každé fáze a zda strom obstál ve všech kontrolách</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogram</translation>
    </message>
    <message>
        <source>draw histograms of the leaves' size and depth in N bands</source>
        <translation>nakreslit histogramy velikosti a hloubky listů v N pásmech</translation>
    </message>
</context>
</TS>
