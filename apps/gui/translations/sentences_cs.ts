<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="cs" sourcelanguage="en">
<context>
    <name>Server</name>
    <message>
        <source>'also' is true or false</source>
        <translation>'also' je true nebo false</translation>
    </message>
    <message>
        <source>'args' is a list of {0} at most</source>
        <translation>'args' je seznam, nejvýše {0} položek</translation>
    </message>
    <message>
        <source>'do' is a text</source>
        <translation>'do' je text</translation>
    </message>
    <message>
        <source>'name' is a text</source>
        <translation>'name' je text</translation>
    </message>
    <message>
        <source>'{0}' cannot name an instance: use 1 to 32 letters, digits, '_' or '-'</source>
        <translation>'{0}' nemůže být jméno instance: použijte 1 až 32 písmen, číslic, '_' nebo '-'</translation>
    </message>
    <message>
        <source>'{0}' is no day from 1800 to 2200 such as {1}</source>
        <translation>'{0}' není den od roku 1800 do 2200, například {1}</translation>
    </message>
    <message>
        <source>'{1}' does not belong on this line; begin a new one, or a comment with #</source>
        <translation>'{1}' na tento řádek nepatří; začněte nový, nebo komentář znakem #</translation>
    </message>
    <message>
        <source>'{2}' is there twice; keep one of them</source>
        <translation>'{2}' je tu dvakrát; jedno z nich odstraňte</translation>
    </message>
    <message>
        <source>--quality counts with --fast only</source>
        <translation>--quality platí jen spolu s --fast</translation>
    </message>
    <message>
        <source>A viewer asks to drive</source>
        <translation>Divák žádá o řízení</translation>
    </message>
    <message>
        <source>Assimp cannot read it: {0}; open it in the program that wrote it and export it again, as glTF or OBJ for example</source>
        <translation>Assimp ho nedokáže načíst a hlásí anglicky: „{0}“; otevřete ho v programu, který ho zapsal, a exportujte znovu, například jako glTF nebo OBJ</translation>
    </message>
    <message>
        <source>BMP of an unknown kind ({0} bits, compression {1})</source>
        <translation>BMP neznámého druhu (bitů: {0}, komprese: {1})</translation>
    </message>
    <message>
        <source>BMP with an unknown header</source>
        <translation>BMP s neznámou hlavičkou</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>nedostatek paměti</translation>
    </message>
    <message>
        <source>DATE is a day from 1800 to 2200, such as 2026-06-21</source>
        <translation>DATE je den od roku 1800 do 2200, například 2026-06-21</translation>
    </message>
    <message>
        <source>Directory not empty</source>
        <translation>složka není prázdná</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>disková kvóta je vyčerpaná</translation>
    </message>
    <message>
        <source>EXR needs the channels R, G and B, or Y alone; it has none</source>
        <translation>EXR potřebuje kanály R, G a B, nebo samotný Y; nemá žádné</translation>
    </message>
    <message>
        <source>EXR needs the channels R, G and B, or Y alone; it has {0}</source>
        <translation>EXR potřebuje kanály R, G a B, nebo samotný Y; má {0}</translation>
    </message>
    <message>
        <source>EXR with channels of a lower resolution cannot be read</source>
        <translation>EXR s kanály v nižším rozlišení nelze přečíst</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>soubor už existuje</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>jméno souboru je příliš dlouhé</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>soubor je příliš velký</translation>
    </message>
    <message>
        <source>HEIGHT and SPACING are metres, but the unit of the model is a guess; say it first, as by 'units m'</source>
        <translation>HEIGHT a SPACING jsou v metrech, ale jednotka modelu je jen odhad; nejprve ji zadejte, například příkazem 'units m'</translation>
    </message>
    <message>
        <source>ImageMagick cannot read {0} here; convert the file to PNG</source>
        <translation>ImageMagick tu neumí číst {0}; převeďte soubor na PNG</translation>
    </message>
    <message>
        <source>ImageMagick cannot write {0} here; use .png</source>
        <translation>ImageMagick tu neumí zapisovat {0}; použijte .png</translation>
    </message>
    <message>
        <source>ImageMagick wrote nothing</source>
        <translation>ImageMagick nic nezapsal</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>chyba při čtení nebo zápisu</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>je to složka</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>na disku není místo</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>takový soubor ani složka tu není</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>není to složka</translation>
    </message>
    <message>
        <source>Open CASCADE cannot read it ({0}); export it as STL, 3MF or glTF from the CAD program</source>
        <translation>Open CASCADE jej neumí přečíst ({0}); vyexportujte jej z programu CAD jako STL, 3MF nebo glTF</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>operace není povolená</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>přístup odepřen</translation>
    </message>
    <message>
        <source>Radiance image of an unknown kind ({0}); only 32-bit_rle_rgbe is read</source>
        <translation>obraz Radiance neznámého druhu ({0}); čte se jen 32-bit_rle_rgbe</translation>
    </message>
    <message>
        <source>Radiance image with an exposure out of all range</source>
        <translation>obraz Radiance s nesmyslnou expozicí</translation>
    </message>
    <message>
        <source>Radiance image without a line such as "-Y 512 +X 1024"</source>
        <translation>obraz Radiance bez řádku jako "-Y 512 +X 1024"</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>disk je jen pro čtení</translation>
    </message>
    <message>
        <source>TGA with an unknown kind of palette</source>
        <translation>TGA s neznámým druhem palety</translation>
    </message>
    <message>
        <source>TIFF of a kind that cannot be read: {0}</source>
        <translation>TIFF druhu, který nelze přečíst: {0}</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>příliš mnoho odkazů za sebou</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>příliš mnoho otevřených souborů</translation>
    </message>
    <message>
        <source>WITHIN is above 0</source>
        <translation>WITHIN je větší než 0</translation>
    </message>
    <message>
        <source>[[environment]]</source>
        <translation>položek [[environment]]</translation>
    </message>
    <message>
        <source>a .bsp has the pose that it was built in, so the pose {0} is passed over</source>
        <translation>.bsp má pózu, ve které byl sestaven, takže póza {0} se nepoužije</translation>
    </message>
    <message>
        <source>a 7z archive</source>
        <translation>archiv 7z</translation>
    </message>
    <message>
        <source>a = should stand here, not '{0}'; a line reads key = value</source>
        <translation>tady má být =, ne '{0}'; řádek má tvar klíč = hodnota</translation>
    </message>
    <message>
        <source>a BREP file</source>
        <translation>soubor BREP</translation>
    </message>
    <message>
        <source>a DWG drawing, which is not read</source>
        <translation>výkres DWG, který nelze načíst</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>dokument PDF</translation>
    </message>
    <message>
        <source>a Parasolid file of CAD surfaces, which are not read</source>
        <translation>soubor Parasolid s plochami CAD, které nelze načíst</translation>
    </message>
    <message>
        <source>a RAR archive</source>
        <translation>archiv RAR</translation>
    </message>
    <message>
        <source>a STEP file</source>
        <translation>soubor STEP</translation>
    </message>
    <message>
        <source>a USD file, which is not read</source>
        <translation>soubor USD, který nelze načíst</translation>
    </message>
    <message>
        <source>a USDZ file, which is not read</source>
        <translation>soubor USDZ, který nelze načíst</translation>
    </message>
    <message>
        <source>a VRML file, which is not read</source>
        <translation>soubor VRML, který nelze načíst</translation>
    </message>
    <message>
        <source>a ] should stand here, not '{0}'; a section begins with [name] or [[name]]</source>
        <translation>tady má být ], ne '{0}'; oddíl začíná řádkem [jméno] nebo [[jméno]]</translation>
    </message>
    <message>
        <source>a backslash has a meaning of its own in double quotes; write two of them, or put the text in single quotes</source>
        <translation>zpětné lomítko má ve dvojitých uvozovkách zvláštní význam; napište dvě, nebo dejte text do jednoduchých uvozovek</translation>
    </message>
    <message>
        <source>a bookmark needs a name, in UTF-8</source>
        <translation>záložka potřebuje jméno v UTF-8</translation>
    </message>
    <message>
        <source>a camera of the flight is not finite</source>
        <translation>některá kamera letu není konečná</translation>
    </message>
    <message>
        <source>a character stands here that cannot be seen; delete it</source>
        <translation>je tu znak, který není vidět; smažte ho</translation>
    </message>
    <message>
        <source>a comma or ] should stand here, not '{0}'</source>
        <translation>tady má být čárka nebo ], ne '{0}'</translation>
    </message>
    <message>
        <source>a command has up to {0} bytes, none of them NUL; this one has {1}</source>
        <translation>příkaz má nejvýše {0} bajtů a žádný z nich není NUL; tento má {1}</translation>
    </message>
    <message>
        <source>a cosine is not in -1..1</source>
        <translation>některý kosinus není v rozsahu -1..1</translation>
    </message>
    <message>
        <source>a cross of cube faces has 4 x 3 or 3 x 4 squares</source>
        <translation>kříž ze stěn krychle má 4 x 3 nebo 3 x 4 čtverce</translation>
    </message>
    <message>
        <source>a date or time</source>
        <translation>datum nebo čas</translation>
    </message>
    <message>
        <source>a direct ratio</source>
        <translation>podíl přímého světla</translation>
    </message>
    <message>
        <source>a directional light has no lm; give lx, or W for W/m2</source>
        <translation>směrové světlo nemá lm; zadejte lx, nebo W jako W/m2</translation>
    </message>
    <message>
        <source>a directional light has no position; 'light aim' turns it</source>
        <translation>směrové světlo nemá polohu; otáčí ho 'light aim'</translation>
    </message>
    <message>
        <source>a directional light takes one angle, in degrees, at most 180</source>
        <translation>směrové světlo má jeden úhel ve stupních, nejvýše 180</translation>
    </message>
    <message>
        <source>a drawing of a section needs a scene with just one; this one has {0}</source>
        <translation>výkres řezu potřebuje scénu právě s jedním; tato jich má {0}</translation>
    </message>
    <message>
        <source>a few vertices lie more than 100000 times as far off as all others, which are too small to be seen beside them; remove them or place the camera yourself</source>
        <translation>několik vrcholů leží víc než 100000krát dál než všechny ostatní, které vedle nich nejsou vidět; odstraňte je, nebo umístěte kameru sami</translation>
    </message>
    <message>
        <source>a file of Irrlicht, which is not read</source>
        <translation>soubor Irrlichtu, který se nečte</translation>
    </message>
    <message>
        <source>a file of Rhino, which is not read</source>
        <translation>soubor programu Rhino, který nelze načíst</translation>
    </message>
    <message>
        <source>a file packed by bzip2</source>
        <translation>soubor zabalený programem bzip2</translation>
    </message>
    <message>
        <source>a file packed by gzip</source>
        <translation>soubor zabalený programem gzip</translation>
    </message>
    <message>
        <source>a file packed by xz</source>
        <translation>soubor zabalený programem xz</translation>
    </message>
    <message>
        <source>a file packed by zstd</source>
        <translation>soubor zabalený programem zstd</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>konečné číslo</translation>
    </message>
    <message>
        <source>a finite number above {0}</source>
        <translation>konečné číslo větší než {0}</translation>
    </message>
    <message>
        <source>a finite number at least {0}</source>
        <translation>konečné číslo, nejméně {0}</translation>
    </message>
    <message>
        <source>a flight by times ends at its last key; leave closed out</source>
        <translation>let podle časů končí posledním klíčovým snímkem; closed vynechte</translation>
    </message>
    <message>
        <source>a flight has at most {0} key frames</source>
        <translation>let má nejvýše {0} klíčových snímků</translation>
    </message>
    <message>
        <source>a flight takes between 0 and {0} seconds</source>
        <translation>let trvá od 0 do {0} sekund</translation>
    </message>
    <message>
        <source>a frame has 1 to {0} pixels a side, not {1} x {2}</source>
        <translation>strana snímku má 1 až {0} pixelů, ne {1} x {2}</translation>
    </message>
    <message>
        <source>a horizontal angle</source>
        <translation>vodorovný úhel</translation>
    </message>
    <message>
        <source>a key cannot hold '{0}'; it is of letters, digits, - and _, or stands in quotes</source>
        <translation>klíč nemůže obsahovat '{0}'; skládá se z písmen, číslic, - a _, nebo je v uvozovkách</translation>
    </message>
    <message>
        <source>a key frame of a flight at an even speed has no time; leave it out, or set timing = "times"</source>
        <translation>klíčový snímek letu se stálou rychlostí nemá čas; vynechte ho, nebo nastavte timing = "times"</translation>
    </message>
    <message>
        <source>a key has too many parts</source>
        <translation>klíč má příliš mnoho částí</translation>
    </message>
    <message>
        <source>a key is there twice, or once as a value and once as a section; keep one of them</source>
        <translation>klíč je tu dvakrát, nebo jednou jako hodnota a jednou jako oddíl; jeden z nich odstraňte</translation>
    </message>
    <message>
        <source>a key stands on one line; use one quote at each end, not three</source>
        <translation>klíč je na jednom řádku; na každém konci použijte jedny uvozovky, ne troje</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>délka</translation>
    </message>
    <message>
        <source>a library says "{0}"</source>
        <translation>knihovna hlásí anglicky: „{0}“</translation>
    </message>
    <message>
        <source>a line TILT=</source>
        <translation>řádek TILT=</translation>
    </message>
    <message>
        <source>a line cannot begin with '{0}'; it reads key = value, or [name]</source>
        <translation>řádek nemůže začínat '{0}'; má tvar klíč = hodnota, nebo [jméno]</translation>
    </message>
    <message>
        <source>a line of the header is too long</source>
        <translation>řádek hlavičky je příliš dlouhý</translation>
    </message>
    <message>
        <source>a list cannot hold the path '{0}'; rename the file</source>
        <translation>seznam nemůže obsahovat cestu '{0}'; přejmenujte soubor</translation>
    </message>
    <message>
        <source>a model is shown, not a scene; 'save as' makes a scene of it</source>
        <translation>ukazuje se model, ne scéna; scénu z něj udělá 'save as'</translation>
    </message>
    <message>
        <source>a model of SketchUp, which is not read</source>
        <translation>model programu SketchUp, který nelze načíst</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>název</translation>
    </message>
    <message>
        <source>a name in quotes</source>
        <translation>jméno v uvozovkách</translation>
    </message>
    <message>
        <source>a net with {0} inputs; known are 3 (radiance), 6 (with albedo) and 9 (with normals)</source>
        <translation>síť s {0} vstupy; známé jsou 3 (radiance), 6 (s albedem) a 9 (s normálami)</translation>
    </message>
    <message>
        <source>a note needs a name</source>
        <translation>poznámka potřebuje jméno</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>číslo</translation>
    </message>
    <message>
        <source>a number above {0} and at most {1}</source>
        <translation>číslo větší než {0}, nejvýše {1}</translation>
    </message>
    <message>
        <source>a number above {0} and below {1}</source>
        <translation>číslo větší než {0} a menší než {1}</translation>
    </message>
    <message>
        <source>a number at least {0} and at most {1}</source>
        <translation>číslo od {0} do {1}</translation>
    </message>
    <message>
        <source>a number at least {0} and below {1}</source>
        <translation>číslo od {0}, menší než {1}</translation>
    </message>
    <message>
        <source>a number for future use</source>
        <translation>číslo pro budoucí použití</translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation>některé číslo není konečné</translation>
    </message>
    <message>
        <source>a pack is being made already; wait for it, or give it up by 'pack stop'</source>
        <translation>balíček se už vytváří; počkejte na něj, nebo ho zrušte příkazem 'pack stop'</translation>
    </message>
    <message>
        <source>a page of a .pdf is at most 5.08 m wide and high; name a paper, or take a smaller scale</source>
        <translation>stránka .pdf je nejvýš 5,08 m široká a vysoká; zvolte papír nebo menší měřítko</translation>
    </message>
    <message>
        <source>a page takes back its own last edit only</source>
        <translation>stránka může vrátit jen svou vlastní poslední úpravu</translation>
    </message>
    <message>
        <source>a path in quotes</source>
        <translation>cesta v uvozovkách</translation>
    </message>
    <message>
        <source>a plain bitmap holds only 0 and 1</source>
        <translation>textová bitmapa obsahuje jen 0 a 1</translation>
    </message>
    <message>
        <source>a plan is a .svg, .pdf, .dxf, .png or .tif file</source>
        <translation>plán je soubor .svg, .pdf, .dxf, .png nebo .tif</translation>
    </message>
    <message>
        <source>a plane's angle</source>
        <translation>úhel roviny</translation>
    </message>
    <message>
        <source>a point cloud (E57), which has no surfaces</source>
        <translation>mračno bodů (E57), které nemá plochy</translation>
    </message>
    <message>
        <source>a point cloud (LAS or LAZ), which has no surfaces</source>
        <translation>mračno bodů (LAS nebo LAZ), které nemá plochy</translation>
    </message>
    <message>
        <source>a point cloud (PCD), which has no surfaces</source>
        <translation>mračno bodů (PCD), které nemá plochy</translation>
    </message>
    <message>
        <source>a point of the measure has a coordinate beyond 1e12; give one near the model</source>
        <translation>bod míry má souřadnici za 1e12; zadejte bod u modelu</translation>
    </message>
    <message>
        <source>a pointer of Git LFS, not the model itself</source>
        <translation>odkaz Git LFS, ne sám model</translation>
    </message>
    <message>
        <source>a pose is rest, first or the name or number of an animation, @ and seconds, not {0}</source>
        <translation>póza je rest, first nebo název či číslo animace, @ a sekundy, ne {0}</translation>
    </message>
    <message>
        <source>a position lies beyond the end of the file</source>
        <translation>pozice leží za koncem souboru</translation>
    </message>
    <message>
        <source>a quotation mark is not closed</source>
        <translation>uvozovka není uzavřená</translation>
    </message>
    <message>
        <source>a recording is under way: {0}; 'export video stop' ends it</source>
        <translation>už se nahrává: {0}; ukončí to 'export video stop'</translation>
    </message>
    <message>
        <source>a request is a line of a number, a scene and a camera, with tabs between them</source>
        <translation>požadavek je řádek s číslem, scénou a kamerou, oddělenými tabulátory</translation>
    </message>
    <message>
        <source>a request is an object</source>
        <translation>požadavek je objekt</translation>
    </message>
    <message>
        <source>a sample is larger than the largest value that the PNM names</source>
        <translation>vzorek je větší než největší hodnota, kterou PNM udává</translation>
    </message>
    <message>
        <source>a scene is saved as a .scn file, not as {0}</source>
        <translation>scéna se ukládá jako soubor .scn, ne jako {0}</translation>
    </message>
    <message>
        <source>a section begins with [name] or [[name]]</source>
        <translation>oddíl začíná řádkem [jméno] nebo [[jméno]]</translation>
    </message>
    <message>
        <source>a section has no proper name</source>
        <translation>některý oddíl nemá řádné jméno</translation>
    </message>
    <message>
        <source>a side of the luminaire</source>
        <translation>rozměr svítidla</translation>
    </message>
    <message>
        <source>a sky of another strength than 1</source>
        <translation>obloha jiné síly než 1</translation>
    </message>
    <message>
        <source>a sky that was modelled around it keeps the light out; make it a part of its own</source>
        <translation>obloha vymodelovaná kolem něj nepropouští světlo; udělejte z ní samostatnou část</translation>
    </message>
    <message>
        <source>a strip of cube faces has 6 x 1 or 1 x 6 squares</source>
        <translation>pás ze stěn krychle má 6 x 1 nebo 1 x 6 čtverců</translation>
    </message>
    <message>
        <source>a sun that was edited</source>
        <translation>upravené slunce</translation>
    </message>
    <message>
        <source>a switch is neither 0 nor 1</source>
        <translation>některý přepínač není 0 ani 1</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>tabulka</translation>
    </message>
    <message>
        <source>a table, [{0}]</source>
        <translation>tabulka, [{0}]</translation>
    </message>
    <message>
        <source>a tar archive</source>
        <translation>archiv tar</translation>
    </message>
    <message>
        <source>a tensor has an unknown layout</source>
        <translation>tenzor má neznámé uspořádání</translation>
    </message>
    <message>
        <source>a tensor has an unknown type of numbers</source>
        <translation>tenzor má neznámý druh čísel</translation>
    </message>
    <message>
        <source>a tensor has neither 1 nor 4 dimensions</source>
        <translation>tenzor nemá ani 1, ani 4 rozměry</translation>
    </message>
    <message>
        <source>a tensor has the side {0}, not 1 to {1}</source>
        <translation>tenzor má stranu {0}, ne 1 až {1}</translation>
    </message>
    <message>
        <source>a text does not end; close its quotes on the same line</source>
        <translation>text nekončí; uzavřete jeho uvozovky na tomtéž řádku</translation>
    </message>
    <message>
        <source>a texture is turned on its surface; that is not supported, so it is not turned</source>
        <translation>textura je na povrchu natočená; to se nepodporuje, takže natočená není</translation>
    </message>
    <message>
        <source>a tilt</source>
        <translation>sklon</translation>
    </message>
    <message>
        <source>a turntable has one key frame and an even speed</source>
        <translation>otočný stůl má jeden klíčový snímek a stálou rychlost</translation>
    </message>
    <message>
        <source>a turntable has one key frame; make a flight by times of it, or another flight</source>
        <translation>otočný stůl má jeden klíčový snímek; udělejte z něj let podle časů, nebo jiný let</translation>
    </message>
    <message>
        <source>a turntable needs the target that it turns about</source>
        <translation>otočný stůl potřebuje cíl, kolem kterého se otáčí</translation>
    </message>
    <message>
        <source>a turntable turns at most {0} times, either way</source>
        <translation>otočný stůl se otočí nejvýše {0}krát, na kteroukoli stranu</translation>
    </message>
    <message>
        <source>a turntable turns; give a number other than 0</source>
        <translation>otočný stůl se otáčí; zadejte jiné číslo než 0</translation>
    </message>
    <message>
        <source>a unit is auto, mm, cm, m, in, ft or a number of metres, not {0}</source>
        <translation>jednotka je auto, mm, cm, m, in, ft nebo počet metrů, ne {0}</translation>
    </message>
    <message>
        <source>a value is a boolean, a number or a text</source>
        <translation>hodnota je true nebo false, číslo, nebo text</translation>
    </message>
    <message>
        <source>a value is missing here</source>
        <translation>tady chybí hodnota</translation>
    </message>
    <message>
        <source>a variant hides and shows parts; give this to a [[part]] of the scene</source>
        <translation>varianta součásti skrývá a zobrazuje; toto dejte do [[part]] scény</translation>
    </message>
    <message>
        <source>a variant takes no textures from files; give it to a [[material]] of the scene</source>
        <translation>varianta nepřijímá textury ze souborů; dejte ji do [[material]] scény</translation>
    </message>
    <message>
        <source>a vertical angle</source>
        <translation>svislý úhel</translation>
    </message>
    <message>
        <source>a web page, not a model</source>
        <translation>webová stránka, ne model</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>celé číslo</translation>
    </message>
    <message>
        <source>a whole number from {0} to {1}</source>
        <translation>celé číslo od {0} do {1}</translation>
    </message>
    <message>
        <source>a word</source>
        <translation>slovo</translation>
    </message>
    <message>
        <source>a word is one of {0}</source>
        <translation>slovo je jedno z: {0}</translation>
    </message>
    <message>
        <source>a zip archive</source>
        <translation>archiv zip</translation>
    </message>
    <message>
        <source>a {0} light has no cone</source>
        <translation>{0} světlo nemá kužel</translation>
    </message>
    <message>
        <source>a {0} light has no surface that mirrors show</source>
        <translation>{0} světlo nemá plochu, kterou by ukazovala zrcadla</translation>
    </message>
    <message>
        <source>a {0} light is the same however it is turned about its direction</source>
        <translation>světlo druhu {0} vypadá stejně, ať je kolem svého směru natočeno jakkoli</translation>
    </message>
    <message>
        <source>a {0} light shines to all sides; 'light kind' changes that</source>
        <translation>{0} světlo svítí na všechny strany; to změní 'light kind'</translation>
    </message>
    <message>
        <source>a {0} light takes WIDTH and HEIGHT</source>
        <translation>{0} světlo má šířku a výšku: WIDTH a HEIGHT</translation>
    </message>
    <message>
        <source>a {0} light takes a radius alone</source>
        <translation>{0} světlo má jen poloměr</translation>
    </message>
    <message>
        <source>action</source>
        <translation>akce</translation>
    </message>
    <message>
        <source>activeEnvironment is {0}, but there are {1} {2}, counted from 0</source>
        <translation>activeEnvironment je {0}, ale je tu {1} {2}, počítáno od 0</translation>
    </message>
    <message>
        <source>all intensities are zero; choose the file of a luminaire that gives off light</source>
        <translation>všechny svítivosti jsou nulové; vyberte soubor svítidla, které svítí</translation>
    </message>
    <message>
        <source>all of its geometry is damaged; copy or export it again</source>
        <translation>celá jeho geometrie je poškozená; zkopírujte nebo exportujte jej znovu</translation>
    </message>
    <message>
        <source>all of its parts are hidden; show them in the program that wrote it and export it again</source>
        <translation>všechny jeho části jsou skryté; zobrazte je v programu, který ho zapsal, a exportujte ho znovu</translation>
    </message>
    <message>
        <source>all variants of its materials but the first</source>
        <translation>všechny varianty jeho materiálů kromě první</translation>
    </message>
    <message>
        <source>alphas: there must be none or one per normal</source>
        <translation>alphas: nesmí být žádné, nebo musí být jedna na každou normálu</translation>
    </message>
    <message>
        <source>aluminium</source>
        <translation>hliník</translation>
    </message>
    <message>
        <source>ambient light</source>
        <translation>okolní světlo</translation>
    </message>
    <message>
        <source>an Alembic file, which is not read</source>
        <translation>soubor Alembic, který nelze načíst</translation>
    </message>
    <message>
        <source>an HDF5 file, which is not read</source>
        <translation>soubor HDF5, který nelze načíst</translation>
    </message>
    <message>
        <source>an IGES file</source>
        <translation>soubor IGES</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>úhel</translation>
    </message>
    <message>
        <source>an angle needs two points beside the one that it is at</source>
        <translation>úhel potřebuje dva body vedle toho, v němž je</translation>
    </message>
    <message>
        <source>an angle of the axis</source>
        <translation>úhel od osy</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>pole</translation>
    </message>
    <message>
        <source>an environment</source>
        <translation>prostředí</translation>
    </message>
    <message>
        <source>an environment has exactly one of the keys equirectangular, cross, strip, faces and parts</source>
        <translation>environment má právě jeden z klíčů equirectangular, cross, strip, faces a parts</translation>
    </message>
    <message>
        <source>an environment is twice as wide as high, or a cross of 4 x 3 or 3 x 4 squares, or a strip of 6 x 1 or 1 x 6</source>
        <translation>mapa okolí je dvakrát širší než vyšší, nebo kříž 4 x 3 či 3 x 4 čtverců, nebo pás 6 x 1 či 1 x 6</translation>
    </message>
    <message>
        <source>an equirectangular map is twice as wide as high</source>
        <translation>ekvirektangulární mapa má dvojnásobnou šířku oproti výšce</translation>
    </message>
    <message>
        <source>an image</source>
        <translation>obraz</translation>
    </message>
    <message>
        <source>an image of {0} x {1} pixels cannot be written</source>
        <translation>obraz o velikosti {0} x {1} pixelů nelze zapsat</translation>
    </message>
    <message>
        <source>an intensity</source>
        <translation>svítivost</translation>
    </message>
    <message>
        <source>another bookmark is called {0}</source>
        <translation>jiná záložka se jmenuje {0}</translation>
    </message>
    <message>
        <source>another bookmark is called {0}, too</source>
        <translation>i jiná záložka se jmenuje {0}</translation>
    </message>
    <message>
        <source>another client moves the camera</source>
        <translation>kamerou hýbe jiný klient</translation>
    </message>
    <message>
        <source>another drives now</source>
        <translation>teď řídí někdo jiný</translation>
    </message>
    <message>
        <source>another flight is called {0}</source>
        <translation>{0} se jmenuje jiný let</translation>
    </message>
    <message>
        <source>another flight is called {0}, too</source>
        <translation>{0} se jmenuje i jiný let</translation>
    </message>
    <message>
        <source>another scene is being loaded</source>
        <translation>načítá se jiná scéna</translation>
    </message>
    <message>
        <source>another scene is shown by now</source>
        <translation>zatím se zobrazila jiná scéna</translation>
    </message>
    <message>
        <source>another scene was shown</source>
        <translation>ukázala se jiná scéna</translation>
    </message>
    <message>
        <source>another variant is called {0}</source>
        <translation>jiná varianta se jmenuje {0}</translation>
    </message>
    <message>
        <source>another variant is called {0}, too</source>
        <translation>jiná varianta se také jmenuje {0}</translation>
    </message>
    <message>
        <source>as you say</source>
        <translation>jak jste určili</translation>
    </message>
    <message>
        <source>asks for environment {0} (counted from 0), but the scene has {1}</source>
        <translation>chce mapu okolí {0} (počítáno od 0), ale scéna jich má {1}</translation>
    </message>
    <message>
        <source>at least {0}</source>
        <translation>nejméně {0}</translation>
    </message>
    <message>
        <source>black is no colour of a light; switch it off instead</source>
        <translation>světlo nemůže být černé; raději ho zhasněte</translation>
    </message>
    <message>
        <source>black-paint</source>
        <translation>černý nátěr</translation>
    </message>
    <message>
        <source>bloom off</source>
        <translation>záře vypnuta</translation>
    </message>
    <message>
        <source>bloom on</source>
        <translation>záře zapnuta</translation>
    </message>
    <message>
        <source>brass</source>
        <translation>mosaz</translation>
    </message>
    <message>
        <source>bronze</source>
        <translation>bronz</translation>
    </message>
    <message>
        <source>by its floors and walls</source>
        <translation>podle podlah a stěn</translation>
    </message>
    <message>
        <source>by its shape</source>
        <translation>podle tvaru</translation>
    </message>
    <message>
        <source>by its size</source>
        <translation>podle velikosti</translation>
    </message>
    <message>
        <source>camera pivot takes RIGHT and DOWN, or neither</source>
        <translation>camera pivot bere RIGHT a DOWN, nebo nic</translation>
    </message>
    <message>
        <source>camera {0} is left out: it looks nowhere</source>
        <translation>kamera {0} je vynechána: nemá směr pohledu</translation>
    </message>
    <message>
        <source>cannot be copied: it is no file, or gone</source>
        <translation>nelze zkopírovat: není to soubor, nebo už tu není</translation>
    </message>
    <message>
        <source>cannot be read: {0}</source>
        <translation>nelze přečíst: {0}</translation>
    </message>
    <message>
        <source>cannot be started: {0}</source>
        <translation>nelze spustit: {0}</translation>
    </message>
    <message>
        <source>cannot be started: {0}; close some programs</source>
        <translation>nelze spustit: {0}; ukončete některé programy</translation>
    </message>
    <message>
        <source>cannot be written: {0}</source>
        <translation>nelze zapsat: {0}</translation>
    </message>
    <message>
        <source>cannot be written: {0} is a link that another user put into a folder where everybody may write; choose another name or another folder</source>
        <translation>nelze zapsat: {0} je odkaz, který jiný uživatel vložil do složky, kam smí zapisovat každý; zvolte jiné jméno nebo jinou složku</translation>
    </message>
    <message>
        <source>cannot read back from the folder for temporary files</source>
        <translation>ze složky pro dočasné soubory nelze číst</translation>
    </message>
    <message>
        <source>cannot write images with this extension, only {0}</source>
        <translation>obrazy s touto příponou nelze zapsat, jen {0}</translation>
    </message>
    <message>
        <source>cell {0} makes no sense</source>
        <translation>buňka {0} nedává smysl</translation>
    </message>
    <message>
        <source>ceramic</source>
        <translation>keramika</translation>
    </message>
    <message>
        <source>channels of its animation that are damaged and passed over: {0}</source>
        <translation>poškozené a vynechané kanály jeho animace: {0}</translation>
    </message>
    <message>
        <source>check its permissions, or name another place</source>
        <translation>zkontrolujte její oprávnění, nebo zvolte jiné místo</translation>
    </message>
    <message>
        <source>chrome</source>
        <translation>chrom</translation>
    </message>
    <message>
        <source>clear-glass</source>
        <translation>čiré sklo</translation>
    </message>
    <message>
        <source>colours below images vary over triangles; each image is laid on one colour</source>
        <translation>barvy pod obrázky se v trojúhelnících mění; každý obrázek je položen na jednu barvu</translation>
    </message>
    <message>
        <source>colours: there must be none or one per normal</source>
        <translation>colours: nesmí být žádné, nebo musí být jedna na každou normálu</translation>
    </message>
    <message>
        <source>command</source>
        <translation>příkaz</translation>
    </message>
    <message>
        <source>command queue {0}: {1}</source>
        <translation>fronta příkazů {0}: {1}</translation>
    </message>
    <message>
        <source>concrete</source>
        <translation>beton</translation>
    </message>
    <message>
        <source>copper</source>
        <translation>měď</translation>
    </message>
    <message>
        <source>damaged EXR: {0}</source>
        <translation>poškozený EXR: {0}</translation>
    </message>
    <message>
        <source>damaged JPEG: {0}</source>
        <translation>poškozený JPEG: {0}</translation>
    </message>
    <message>
        <source>damaged PFM: its header has lines for the kind, the size and the byte order</source>
        <translation>poškozený PFM: hlavička má řádky s druhem, velikostí a pořadím bajtů</translation>
    </message>
    <message>
        <source>damaged PNG: {0}</source>
        <translation>poškozený PNG: {0}</translation>
    </message>
    <message>
        <source>damaged PNM: a number was expected</source>
        <translation>poškozený PNM: mělo tu být číslo</translation>
    </message>
    <message>
        <source>damaged Radiance image: a row of another width</source>
        <translation>poškozený obraz Radiance: řádek s jinou šířkou</translation>
    </message>
    <message>
        <source>damaged Radiance image: a run too long</source>
        <translation>poškozený obraz Radiance: příliš dlouhé opakování</translation>
    </message>
    <message>
        <source>damaged TGA: a pixel lies outside of the palette</source>
        <translation>poškozený TGA: pixel mimo paletu</translation>
    </message>
    <message>
        <source>damaged TIFF: its directory cannot be read</source>
        <translation>poškozený TIFF: nelze přečíst jeho adresář</translation>
    </message>
    <message>
        <source>damaged TIFF: its pixels cannot be decoded</source>
        <translation>poškozený TIFF: pixely nelze dekódovat</translation>
    </message>
    <message>
        <source>damaged TIFF: row {0} cannot be decoded</source>
        <translation>poškozený TIFF: řádek {0} nelze dekódovat</translation>
    </message>
    <message>
        <source>damaged TIFF: rows of an odd size</source>
        <translation>poškozený TIFF: řádky zvláštní délky</translation>
    </message>
    <message>
        <source>damaged {0}: {1}</source>
        <translation>poškozený {0}: {1}</translation>
    </message>
    <message>
        <source>denoise.net: no weights in {0} ({1}); {2} brings them</source>
        <translation>denoise.net: v {0} nejsou váhy ({1}); přinese je {2}</translation>
    </message>
    <message>
        <source>diffuse and specular together exceed 1</source>
        <translation>diffuse a specular dávají dohromady víc než 1</translation>
    </message>
    <message>
        <source>diffuse and specular together exceed 1; a surface gives back no more light than it gets</source>
        <translation>diffuse a specular jsou dohromady víc než 1; povrch nevrací víc světla, než dostane</translation>
    </message>
    <message>
        <source>diffuseTexture names a file, which only a .scn file can give</source>
        <translation>diffuseTexture je jméno souboru, to může udat jen soubor .scn</translation>
    </message>
    <message>
        <source>direction is not of unit length</source>
        <translation>direction nemá jednotkovou délku</translation>
    </message>
    <message>
        <source>direction is that to the sun, and not zero</source>
        <translation>direction je směr ke slunci a není nulový</translation>
    </message>
    <message>
        <source>direction is zero; give where the light shines to</source>
        <translation>direction je nulový; zadejte, kam světlo svítí</translation>
    </message>
    <message>
        <source>directional</source>
        <translation>směrové</translation>
    </message>
    <message>
        <source>download the file itself</source>
        <translation>stáhněte sám soubor</translation>
    </message>
    <message>
        <source>each point of a chain has three numbers</source>
        <translation>každý bod řetězce má tři čísla</translation>
    </message>
    <message>
        <source>edit {0} is not the last one</source>
        <translation>úprava {0} není poslední</translation>
    </message>
    <message>
        <source>edit {0} is not the one that was taken back</source>
        <translation>úprava {0} není ta, která byla vrácena</translation>
    </message>
    <message>
        <source>edits are locked here</source>
        <translation>úpravy jsou zde zamčené</translation>
    </message>
    <message>
        <source>environment {0}</source>
        <translation>mapa okolí {0}</translation>
    </message>
    <message>
        <source>every material is fully transparent, so nothing can be seen; give them an opacity</source>
        <translation>všechny materiály jsou úplně průhledné, takže není nic vidět; dejte jim krytí</translation>
    </message>
    <message>
        <source>export it as FBX, STL or DXF from the CAD program</source>
        <translation>exportujte ho z programu CAD jako FBX, STL nebo DXF</translation>
    </message>
    <message>
        <source>export it as STL, 3MF or glTF from the CAD program</source>
        <translation>exportujte ho z programu CAD jako STL, 3MF nebo glTF</translation>
    </message>
    <message>
        <source>export it as glTF or Collada from SketchUp</source>
        <translation>exportujte ho ze SketchUpu jako glTF nebo Collada</translation>
    </message>
    <message>
        <source>export it as glTF, OBJ or STL from Rhino</source>
        <translation>exportujte ho z Rhina jako glTF, OBJ nebo STL</translation>
    </message>
    <message>
        <source>export the model as X3D or glTF</source>
        <translation>exportujte model jako X3D nebo glTF</translation>
    </message>
    <message>
        <source>export the model as glTF</source>
        <translation>exportujte model jako glTF</translation>
    </message>
    <message>
        <source>export the model as glTF or OBJ</source>
        <translation>exportujte model jako glTF nebo OBJ</translation>
    </message>
    <message>
        <source>export the model as glTF, OBJ or PLY from the app that made it, or by Blender (blender.org), which opens it</source>
        <translation>vyexportujte model jako glTF, OBJ nebo PLY z aplikace, která jej vytvořila, nebo z Blenderu (blender.org), který jej otevře</translation>
    </message>
    <message>
        <source>export with a node for each instance (gltfpack without -mi)</source>
        <translation>exportujte s vlastním uzlem pro každou instanci (gltfpack bez -mi)</translation>
    </message>
    <message>
        <source>export with images of PNG or JPEG</source>
        <translation>exportujte s obrazy PNG nebo JPEG</translation>
    </message>
    <message>
        <source>export with images of PNG or JPEG (gltfpack without -tc and -tu)</source>
        <translation>exportujte s obrazy PNG nebo JPEG (gltfpack bez -tc a -tu)</translation>
    </message>
    <message>
        <source>export with images of PNG or JPEG (gltfpack without -tw)</source>
        <translation>exportujte s obrazy PNG nebo JPEG (gltfpack bez -tw)</translation>
    </message>
    <message>
        <source>export without it</source>
        <translation>exportujte bez něj</translation>
    </message>
    <message>
        <source>export without it (gltf-pipeline without -d)</source>
        <translation>exportujte bez něj (gltf-pipeline bez -d)</translation>
    </message>
    <message>
        <source>export without it (gltfpack -noq, without -c and -cc)</source>
        <translation>exportujte bez něj (gltfpack -noq, bez -c a -cc)</translation>
    </message>
    <message>
        <source>export without it (gltfpack without -c and -cc)</source>
        <translation>exportujte bez něj (gltfpack bez -c a -cc)</translation>
    </message>
    <message>
        <source>faces has {0} files, but takes six: +x, -x, +y, -y, +z, -z</source>
        <translation>faces má {0} souborů, ale bere šest: +x, -x, +y, -y, +z, -z</translation>
    </message>
    <message>
        <source>fetch the model (git lfs pull)</source>
        <translation>stáhněte model (git lfs pull)</translation>
    </message>
    <message>
        <source>file is empty; name an IES or EULUMDAT file</source>
        <translation>file je prázdné; uveďte soubor IES nebo EULUMDAT</translation>
    </message>
    <message>
        <source>flight target takes three coordinates behind the name, or none</source>
        <translation>flight target má za jménem tři souřadnice, nebo žádnou</translation>
    </message>
    <message>
        <source>flying</source>
        <translation>let</translation>
    </message>
    <message>
        <source>fog</source>
        <translation>mlha</translation>
    </message>
    <message>
        <source>forward and up are parallel</source>
        <translation>forward a up jsou rovnoběžné</translation>
    </message>
    <message>
        <source>forward is zero; the camera needs a direction</source>
        <translation>forward je nulový; kamera potřebuje směr</translation>
    </message>
    <message>
        <source>forward or up is zero or not a number</source>
        <translation>forward nebo up je nula nebo to není číslo</translation>
    </message>
    <message>
        <source>frame {0} has {1} pixels, those before it {2}; give all of them one size by -w and -h</source>
        <translation>snímek {0} má {1} pixelů, předchozí {2}; dejte všem stejnou velikost pomocí -w a -h</translation>
    </message>
    <message>
        <source>free some space or set TMPDIR to another folder</source>
        <translation>uvolněte místo, nebo nastavte TMPDIR na jinou složku</translation>
    </message>
    <message>
        <source>frosted-glass</source>
        <translation>matné sklo</translation>
    </message>
    <message>
        <source>give a model</source>
        <translation>zadejte model</translation>
    </message>
    <message>
        <source>given up: the frame that it needs takes too long for the commands behind it; send them later</source>
        <translation>vzdáno: snímek, který je k tomu potřeba, trvá příkazům za ním příliš dlouho; pošlete je později</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>sklo</translation>
    </message>
    <message>
        <source>gold</source>
        <translation>zlato</translation>
    </message>
    <message>
        <source>granite</source>
        <translation>žula</translation>
    </message>
    <message>
        <source>grey-paint</source>
        <translation>šedý nátěr</translation>
    </message>
    <message>
        <source>guessed</source>
        <translation>odhad</translation>
    </message>
    <message>
        <source>guessed: {0}</source>
        <translation>odhad: {0}</translation>
    </message>
    <message>
        <source>header: damaged (its checksum differs)</source>
        <translation>hlavička: je poškozená (nesouhlasí kontrolní součet)</translation>
    </message>
    <message>
        <source>header: its flags make no sense</source>
        <translation>hlavička: její příznaky nedávají smysl</translation>
    </message>
    <message>
        <source>header: its reserved fields are not zero</source>
        <translation>hlavička: její vyhrazená pole nejsou nulová</translation>
    </message>
    <message>
        <source>header: of the wrong size</source>
        <translation>hlavička: má špatnou velikost</translation>
    </message>
    <message>
        <source>header: the bounds are no box</source>
        <translation>hlavička: meze netvoří kvádr</translation>
    </message>
    <message>
        <source>header: the file is cut off</source>
        <translation>hlavička: soubor je neúplný</translation>
    </message>
    <message>
        <source>header: written by a machine of the other byte order</source>
        <translation>hlavička: zapsána počítačem s opačným pořadím bajtů</translation>
    </message>
    <message>
        <source>header: written by another version of BSPBuilder</source>
        <translation>hlavička: zapsána jinou verzí programu BSPBuilder</translation>
    </message>
    <message>
        <source>height maps of {0}</source>
        <translation>výškové mapy z programu {0}</translation>
    </message>
    <message>
        <source>holds a line of more than a megabyte; it is no text</source>
        <translation>obsahuje řádek delší než megabajt; není to text</translation>
    </message>
    <message>
        <source>holds more than {0} bytes; no file of this kind is so large</source>
        <translation>má víc než {0} bajtů; žádný takový soubor není tak velký</translation>
    </message>
    <message>
        <source>idling was turned off</source>
        <translation>klid byl vypnut</translation>
    </message>
    <message>
        <source>ies</source>
        <translation>IES</translation>
    </message>
    <message>
        <source>ignored, since not supported: {0}</source>
        <translation>ignorováno, protože se nepodporuje: {0}</translation>
    </message>
    <message>
        <source>ignored, since not supported: {0}; lost: {1}</source>
        <translation>ignorováno, protože to není podporováno: {0}; ztraceno: {1}</translation>
    </message>
    <message>
        <source>images of AVIF, whose materials are plain</source>
        <translation>obrázky AVIF, jejichž materiály jsou jednobarevné</translation>
    </message>
    <message>
        <source>images of Basis Universal, whose materials are plain</source>
        <translation>obrázky Basis Universal, jejichž materiály jsou jednobarevné</translation>
    </message>
    <message>
        <source>indirect light is not kept: {0}</source>
        <translation>nepřímé světlo se neuchovává: {0}</translation>
    </message>
    <message>
        <source>indirect light is rendered, and {0} stand in for it: it counts twice; to switch them off: {1}</source>
        <translation>nepřímé světlo se počítá a {0} ho jen nahrazují: započítá se dvakrát; zhasnete je takto: {1}</translation>
    </message>
    <message>
        <source>innerAngle must be below outerAngle, by enough to tell them apart</source>
        <translation>innerAngle musí být znatelně menší než outerAngle</translation>
    </message>
    <message>
        <source>integrator {0} does not use {1}</source>
        <translation>integrátor {0} nepoužívá {1}</translation>
    </message>
    <message>
        <source>is no .bsp file of this suite (other programs use the same ending)</source>
        <translation>není soubor .bsp této sady programů (stejnou příponu používají i jiné)</translation>
    </message>
    <message>
        <source>is no file of indirect light of this suite</source>
        <translation>není soubor nepřímého světla této sady programů</translation>
    </message>
    <message>
        <source>is of other surfaces; make one of this scene by --make-light</source>
        <translation>patří k jiným povrchům; vytvořte soubor této scény pomocí --make-light</translation>
    </message>
    <message>
        <source>is of the same surfaces by another light; make it anew by --make-light</source>
        <translation>patří ke stejným povrchům v jiném osvětlení; vytvořte jej znovu pomocí --make-light</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>nelze to přečíst</translation>
    </message>
    <message>
        <source>it ends after {0} of the {1} elements {2} that its head promises</source>
        <translation>končí po {0} z {1} prvků {2}, které slibuje hlavička</translation>
    </message>
    <message>
        <source>it ends before the last of the {0} elements {1} that its head promises</source>
        <translation>končí dřív než poslední z {0} prvků {1}, které slibuje hlavička</translation>
    </message>
    <message>
        <source>it ends before the last of the {0} triangles that its head promises; it is damaged: copy or export it again</source>
        <translation>končí dřív než poslední z {0} trojúhelníků, které slibuje hlavička; je poškozený: zkopírujte nebo exportujte ho znovu</translation>
    </message>
    <message>
        <source>it ends outside of the texels</source>
        <translation>končí mimo oddíl texels</translation>
    </message>
    <message>
        <source>it has more than 2^30 nodes</source>
        <translation>má víc než 2^30 uzlů</translation>
    </message>
    <message>
        <source>it has more than 2^30 triangles; split the model</source>
        <translation>má víc než 2^30 trojúhelníků; rozdělte model</translation>
    </message>
    <message>
        <source>it has more than {0} numbers</source>
        <translation>má více než {0} čísel</translation>
    </message>
    <message>
        <source>it has more than {0} tensors</source>
        <translation>má více než {0} tenzorů</translation>
    </message>
    <message>
        <source>it has no animation {0}, nor any other; leave the pose out</source>
        <translation>nemá animaci {0} ani žádnou jinou; pózu vynechte</translation>
    </message>
    <message>
        <source>it has no animation {0}; name one of these: {1}</source>
        <translation>nemá animaci {0}; zadejte jednu z těchto: {1}</translation>
    </message>
    <message>
        <source>it has no animation, so it stands as its nodes say</source>
        <translation>nemá animaci, takže stojí tak, jak určují jeho uzly</translation>
    </message>
    <message>
        <source>it has no flight {0}, but {1}</source>
        <translation>nemá let {0}, ale {1}</translation>
    </message>
    <message>
        <source>it has no flight {0}, nor any other; a .scn has them, and --turntable needs none</source>
        <translation>nemá let {0} ani žádný jiný; má je .scn, a --turntable žádný nepotřebuje</translation>
    </message>
    <message>
        <source>it has no nodes</source>
        <translation>nemá žádné uzly</translation>
    </message>
    <message>
        <source>it has no variant {0}, but {1}</source>
        <translation>nemá variantu {0}, ale {1}</translation>
    </message>
    <message>
        <source>it has no variant {0}, nor any other; a .scn has them</source>
        <translation>nemá variantu {0} ani žádnou jinou; varianty má soubor .scn</translation>
    </message>
    <message>
        <source>it has one vertical angle; two or more are needed</source>
        <translation>má jediný svislý úhel; jsou potřeba aspoň dva</translation>
    </message>
    <message>
        <source>it has samples of an unusual kind</source>
        <translation>má vzorky neobvyklého druhu</translation>
    </message>
    <message>
        <source>it has samples of {0} bits</source>
        <translation>má vzorky o {0} bitech</translation>
    </message>
    <message>
        <source>it has too many texels</source>
        <translation>má příliš mnoho texelů</translation>
    </message>
    <message>
        <source>it has {0} vertices, more than can be numbered</source>
        <translation>má {0} vrcholů, víc, než lze očíslovat</translation>
    </message>
    <message>
        <source>it holds more than {0} files, as no model does</source>
        <translation>obsahuje více než {0} souborů, což žádný model nemá</translation>
    </message>
    <message>
        <source>it holds no points: none of its lines begins with x, y and z; export them again</source>
        <translation>neobsahuje žádné body: žádný řádek nezačíná x, y a z; vyexportujte je znovu</translation>
    </message>
    <message>
        <source>it holds no triangles ({0} points and lines, {1} triangles without area, {2} with broken coordinates, {3} with corners that do not exist, {4} meshes); give a model with surfaces</source>
        <translation>nemá žádné trojúhelníky (bodů a čar: {0}, trojúhelníků bez plochy: {1}, s vadnými souřadnicemi: {2}, s neexistujícími vrcholy: {3}, sítí: {4}); zadejte model s plochami</translation>
    </message>
    <message>
        <source>it holds no triangles; give a model with surfaces</source>
        <translation>nemá žádné trojúhelníky; zadejte model s plochami</translation>
    </message>
    <message>
        <source>it is a 3MF file by its content; rename it so that it ends in .3mf</source>
        <translation>podle obsahu je to soubor 3MF; přejmenujte ho, aby končil na .3mf</translation>
    </message>
    <message>
        <source>it is a building in {0}, which is not read; export it as IFC2x3 or as glTF</source>
        <translation>je to budova ve formátu {0}, který nelze načíst; exportujte ji jako IFC2x3 nebo glTF</translation>
    </message>
    <message>
        <source>it is a cloud of {0} points, more than fit into the memory that it may use; raise the limit or thin it out (CloudCompare, MeshLab)</source>
        <translation>je to mračno {0} bodů, více, než se vejde do paměti, kterou smí použít; zvyšte mez, nebo je zřeďte (CloudCompare, MeshLab)</translation>
    </message>
    <message>
        <source>it is a cloud of {0} points, more than the {1} that are shown; thin it out or make a mesh of it (CloudCompare, MeshLab) and save that as PLY</source>
        <translation>je to mračno {0} bodů, více než {1}, které se zobrazí; zřeďte je, nebo z něj vytvořte síť (CloudCompare, MeshLab) a tu uložte jako PLY</translation>
    </message>
    <message>
        <source>it is a cloud of {0} points, which has no surfaces; make a mesh of it (CloudCompare, MeshLab) and save that as PLY</source>
        <translation>je to mračno {0} bodů, které nemá plochy; udělejte z něj síť (CloudCompare, MeshLab) a uložte ji jako PLY</translation>
    </message>
    <message>
        <source>it is a document of FreeCAD, which is not read; export it as STL, 3MF or glTF</source>
        <translation>je to dokument programu FreeCAD, který nelze načíst; exportujte ho jako STL, 3MF nebo glTF</translation>
    </message>
    <message>
        <source>it is a file of Blender {0}.{1}, which is not read; export it as glTF from Blender</source>
        <translation>je to soubor Blenderu {0}.{1}, který nelze načíst; exportujte ho z Blenderu jako glTF</translation>
    </message>
    <message>
        <source>it is a file of Blender, which is not read; export it as glTF from Blender</source>
        <translation>je to soubor Blenderu, který nelze načíst; exportujte ho z Blenderu jako glTF</translation>
    </message>
    <message>
        <source>it is a file of a CAD program, which is not read; export it as STL, 3MF or glTF from that program</source>
        <translation>je to soubor programu CAD, který nelze načíst; exportujte ho z toho programu jako STL, 3MF nebo glTF</translation>
    </message>
    <message>
        <source>it is a model of Revit, which is not read; export it as IFC2x3, FBX or glTF from Revit</source>
        <translation>je to model programu Revit, který nelze načíst; exportujte ho z Revitu jako IFC2x3, FBX nebo glTF</translation>
    </message>
    <message>
        <source>it is a molecule, which has no surfaces; export a mesh of it as OBJ or glTF</source>
        <translation>je to molekula, která nemá žádné plochy; vyexportujte její síť jako OBJ nebo glTF</translation>
    </message>
    <message>
        <source>it is a pipe without a writer; give a file</source>
        <translation>je to roura, do které nikdo nepíše; zadejte soubor</translation>
    </message>
    <message>
        <source>it is a scene of 3ds Max, which is not read; export it as FBX or glTF from 3ds Max</source>
        <translation>je to scéna programu 3ds Max, kterou nelze načíst; exportujte ji z 3ds Max jako FBX nebo glTF</translation>
    </message>
    <message>
        <source>it is an FBX file of version {0}.{1}, from before 2011, which is not read; save it as FBX 2011 or later, or as glTF</source>
        <translation>je to soubor FBX verze {0}.{1} z doby před rokem 2011, kterou nelze načíst; uložte ho jako FBX 2011 nebo novější, nebo jako glTF</translation>
    </message>
    <message>
        <source>it is cut off: its JSON does not end within {0} bytes; copy it again</source>
        <translation>je neúplný: jeho JSON ani po {0} bajtech nekončí; zkopírujte ho znovu</translation>
    </message>
    <message>
        <source>it is cut off: the list of what it holds is missing at its end; copy it again</source>
        <translation>je neúplný: na konci chybí seznam jeho obsahu; zkopírujte ho znovu</translation>
    </message>
    <message>
        <source>it is cut off: {0} is missing at its end; copy it again</source>
        <translation>je neúplný: na konci chybí {0}; zkopírujte ho znovu</translation>
    </message>
    <message>
        <source>it is cut off: {0} of at least {1} bytes are there; copy it again</source>
        <translation>je neúplný: má {0} bajtů z nejméně {1}; zkopírujte ho znovu</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>je prázdný</translation>
    </message>
    <message>
        <source>it is empty; export the model again</source>
        <translation>je prázdný; exportujte model znovu</translation>
    </message>
    <message>
        <source>it is filtered in no known way</source>
        <translation>filtruje se neznámým způsobem</translation>
    </message>
    <message>
        <source>it is glTF {0} in a binary file, which is not read; export it as glTF 2.0</source>
        <translation>je to glTF {0} v binárním souboru, který nelze načíst; exportujte ho jako glTF 2.0</translation>
    </message>
    <message>
        <source>it is glTF {0}, which is not read; export it as glTF 2.0</source>
        <translation>je to glTF {0}, který nelze načíst; exportujte ho jako glTF 2.0</translation>
    </message>
    <message>
        <source>it is larger than 4 MB</source>
        <translation>je větší než 4 MB</translation>
    </message>
    <message>
        <source>it is missing in the package</source>
        <translation>v balíčku chybí</translation>
    </message>
    <message>
        <source>it is no .bsp of this suite, or its beginning is damaged; build it again with BSPBuilder</source>
        <translation>není to .bsp této sady programů, nebo má poškozený začátek; vytvořte ho znovu programem BSPBuilder</translation>
    </message>
    <message>
        <source>it is no image any more; choose another environment map</source>
        <translation>už to není obraz; zvolte jinou mapu okolí</translation>
    </message>
    <message>
        <source>it is no model; give the model or .bsp itself</source>
        <translation>není to model; zadejte sám model nebo .bsp</translation>
    </message>
    <message>
        <source>it is no photometric file any more; choose another one</source>
        <translation>už to není fotometrický soubor; vyberte jiný</translation>
    </message>
    <message>
        <source>it is no regular file; give a file</source>
        <translation>není to obyčejný soubor; zadejte soubor</translation>
    </message>
    <message>
        <source>it is no regular file; name another</source>
        <translation>není to obyčejný soubor; zvolte jiný</translation>
    </message>
    <message>
        <source>it is not a file; give the path of a model</source>
        <translation>není to soubor; zadejte cestu k modelu</translation>
    </message>
    <message>
        <source>it is of a kind that is not read; convert it to PNG</source>
        <translation>je druhu, který se nečte; převeďte ho do PNG</translation>
    </message>
    <message>
        <source>it is of no known kind</source>
        <translation>je neznámého druhu</translation>
    </message>
    <message>
        <source>it is of the photometric type {0}; convert it to type C, in which luminaires for rooms and streets are measured</source>
        <translation>je fotometrického typu {0}; převeďte jej na typ C, ve kterém se měří svítidla do místností a na ulice</translation>
    </message>
    <message>
        <source>it is only {0} units large, too small to be traced; scale it up by a factor of {1}</source>
        <translation>měří jen {0} jednotek, takže je na výpočet příliš malý; zvětšete ho {1}krát</translation>
    </message>
    <message>
        <source>it is stored in no known way</source>
        <translation>je uložena neznámým způsobem</translation>
    </message>
    <message>
        <source>it is there already, and not empty; name another folder</source>
        <translation>už tu je a není prázdná; zvolte jinou složku</translation>
    </message>
    <message>
        <source>it is too wide or too high</source>
        <translation>je příliš široký nebo vysoký</translation>
    </message>
    <message>
        <source>it is {0} of CAD surfaces, none of which can be read; export it as STL, 3MF or glTF from the CAD program</source>
        <translation>je to {0} s plochami CAD, z nichž žádnou nelze přečíst; vyexportujte jej z programu CAD jako STL, 3MF nebo glTF</translation>
    </message>
    <message>
        <source>it is {0} of CAD surfaces, which this build does not read, as it lacks Open CASCADE; {1}</source>
        <translation>je to {0} s plochami CAD, které toto sestavení nečte, protože nemá Open CASCADE; {1}</translation>
    </message>
    <message>
        <source>it is {0}; {1}</source>
        <translation>je to {0}; {1}</translation>
    </message>
    <message>
        <source>it lies by texture coordinates that do not exist</source>
        <translation>leží podle souřadnic textur, které neexistují</translation>
    </message>
    <message>
        <source>it names a photometric file, which is not in it</source>
        <translation>odkazuje na fotometrický soubor, který v něm není</translation>
    </message>
    <message>
        <source>it names a texture that does not exist</source>
        <translation>uvádí texturu, která neexistuje</translation>
    </message>
    <message>
        <source>it names files outside of its folder, which are not read: {0}; put them beside the model</source>
        <translation>jmenuje soubory mimo svou složku, které se nečtou: {0}; dejte je vedle modelu</translation>
    </message>
    <message>
        <source>it names no .cam file; write one path a line</source>
        <translation>neuvádí žádný soubor .cam; napište jednu cestu na řádek</translation>
    </message>
    <message>
        <source>it names {0}, which is not there</source>
        <translation>odkazuje na {0}, který tu není</translation>
    </message>
    <message>
        <source>it needs {0} and {1}, which are not read; {2}</source>
        <translation>potřebuje rozšíření {0} a {1}, která nelze načíst; {2}</translation>
    </message>
    <message>
        <source>it needs {0}, which is not read; {1}</source>
        <translation>potřebuje rozšíření {0}, které nelze načíst; {1}</translation>
    </message>
    <message>
        <source>it shines either by a file or as a luminaire of the model</source>
        <translation>svítí buď podle souboru, nebo jako svítidlo modelu</translation>
    </message>
    <message>
        <source>it unpacks to more than {0} times its size, as no model does; it is damaged or made to fill memory</source>
        <translation>rozbaluje se na více než {0}násobek své velikosti, což žádný model nedělá; je poškozený, nebo má zaplnit paměť</translation>
    </message>
    <message>
        <source>it was changed while it was read; build again</source>
        <translation>během čtení se změnil; vytvořte strom znovu</translation>
    </message>
    <message>
        <source>it was written or changed by hand, and its comments and its layout would be lost; add 'replace', then it is kept as {0}</source>
        <translation>byl napsán nebo změněn ručně a ztratil by komentáře i úpravu; přidejte 'replace', pak zůstane jako {0}</translation>
    </message>
    <message>
        <source>it wraps in no known way</source>
        <translation>opakuje se neznámým způsobem</translation>
    </message>
    <message>
        <source>its JSON does not say which version of glTF it is; export it again</source>
        <translation>jeho JSON neříká, která je to verze glTF; exportujte ho znovu</translation>
    </message>
    <message>
        <source>its JSON is damaged at byte {0}; copy or export it again</source>
        <translation>jeho JSON je poškozený u bajtu {0}; zkopírujte nebo exportujte ho znovu</translation>
    </message>
    <message>
        <source>its aspect is out of range</source>
        <translation>jeho poměr stran je mimo rozsah</translation>
    </message>
    <message>
        <source>its assemblies are deeper than {0}; export it again</source>
        <translation>jeho sestavy jsou hlubší než {0}; vyexportujte jej znovu</translation>
    </message>
    <message>
        <source>its assemblies hold themselves; export it again</source>
        <translation>jeho sestavy obsahují samy sebe; vyexportujte jej znovu</translation>
    </message>
    <message>
        <source>its bounds are no box</source>
        <translation>jeho meze netvoří kvádr</translation>
    </message>
    <message>
        <source>its camera {0} shows little or nothing of the model; kept as a bookmark</source>
        <translation>jeho kamera {0} ukazuje z modelu málo nebo nic; zůstává jako záložka</translation>
    </message>
    <message>
        <source>its cameras {0} show little or nothing of the model; kept as bookmarks</source>
        <translation>jeho kamery {0} ukazují z modelu málo nebo nic; zůstávají jako záložky</translation>
    </message>
    <message>
        <source>its cells are not in order</source>
        <translation>jeho buňky nejsou seřazené</translation>
    </message>
    <message>
        <source>its copy does not find {0}; make a .bsp of it by BSPBuilder and pack that</source>
        <translation>jeho kopie nenajde {0}; udělejte z něj programem BSPBuilder .bsp a zabalte ten</translation>
    </message>
    <message>
        <source>its data are damaged or missing</source>
        <translation>jeho data jsou poškozená nebo chybějí</translation>
    </message>
    <message>
        <source>its disc is out of range</source>
        <translation>jeho kotouč je mimo rozsah</translation>
    </message>
    <message>
        <source>its elements are nested more than {0} deep; export it again</source>
        <translation>jeho prvky jsou vnořeny ve více než {0} úrovních; vyexportujte jej znovu</translation>
    </message>
    <message>
        <source>its face {0} claims to have {1} corners</source>
        <translation>stěna {0} má mít {1} vrcholů</translation>
    </message>
    <message>
        <source>its face {0} names the vertex {1} of {2}</source>
        <translation>stěna {0} odkazuje na vrchol {1} z {2}</translation>
    </message>
    <message>
        <source>its file is missing; put it beside the model</source>
        <translation>jeho soubor chybí; dejte ho vedle modelu</translation>
    </message>
    <message>
        <source>its file is not read, as it lies outside of the model's folder; put it beside the model</source>
        <translation>jeho soubor se nečte, protože leží mimo složku modelu; dejte ho vedle modelu</translation>
    </message>
    <message>
        <source>its first chunk holds no JSON; it is damaged: copy or export it again</source>
        <translation>první blok neobsahuje JSON; soubor je poškozený: zkopírujte nebo exportujte ho znovu</translation>
    </message>
    <message>
        <source>its first chunk is longer than the file; it is damaged: copy or export it again</source>
        <translation>první blok je delší než soubor; je poškozený: zkopírujte nebo exportujte ho znovu</translation>
    </message>
    <message>
        <source>its folder {0} cannot be made: {1}</source>
        <translation>jeho složku {0} nelze vytvořit: {1}</translation>
    </message>
    <message>
        <source>its folder {0} exists already; choose another name</source>
        <translation>jeho složka {0} už existuje; zvolte jiné jméno</translation>
    </message>
    <message>
        <source>its geometry is in {0}, which are missing; put them beside the model's file</source>
        <translation>jeho geometrie je v souborech {0}, které chybějí; dejte je vedle souboru modelu</translation>
    </message>
    <message>
        <source>its geometry is in {0}, which is missing; put it beside the model's file</source>
        <translation>jeho geometrie je v souboru {0}, který chybí; dejte ho vedle souboru modelu</translation>
    </message>
    <message>
        <source>its group {0} uses itself (USE); export it again</source>
        <translation>jeho skupina {0} používá sama sebe (USE); vyexportujte jej znovu</translation>
    </message>
    <message>
        <source>its guess or its steps make no sense</source>
        <translation>jeho odhad nebo počet kroků nedává smysl</translation>
    </message>
    <message>
        <source>its head does not end within {0} bytes</source>
        <translation>jeho hlavička ani po {0} bajtech nekončí</translation>
    </message>
    <message>
        <source>its head makes no sense</source>
        <translation>jeho hlavička nedává smysl</translation>
    </message>
    <message>
        <source>its head promises {0} elements {1}, for which it has no room</source>
        <translation>jeho hlavička slibuje {0} prvků {1}, které se do něj nevejdou</translation>
    </message>
    <message>
        <source>its horizontal angles end at {0} degrees; they span 0, 90, 180 or 360</source>
        <translation>jeho vodorovné úhly končí na {0} stupních; mají sahat přes 0, 90, 180 nebo 360</translation>
    </message>
    <message>
        <source>its layers together are too large</source>
        <translation>jeho vrstvy jsou dohromady příliš velké</translation>
    </message>
    <message>
        <source>its model is a scene file too; name a .bsp or a model: {0}</source>
        <translation>jeho model je také soubor scény; zadejte .bsp nebo model: {0}</translation>
    </message>
    <message>
        <source>its name does not fit its content; rename it so that it ends in {0}</source>
        <translation>jméno neodpovídá obsahu; přejmenujte ho, aby končil na {0}</translation>
    </message>
    <message>
        <source>its name lies outside of the strings</source>
        <translation>jeho jméno leží mimo oddíl strings</translation>
    </message>
    <message>
        <source>its node graph has no end; repair the file</source>
        <translation>graf jeho uzlů nemá konec; opravte soubor</translation>
    </message>
    <message>
        <source>its numbers of records differ</source>
        <translation>jeho počty záznamů se liší</translation>
    </message>
    <message>
        <source>its object {0} holds itself, or others in more than {1} levels; export it again</source>
        <translation>jeho objekt {0} obsahuje sám sebe, nebo jiné ve více než {1} úrovních; vyexportujte jej znovu</translation>
    </message>
    <message>
        <source>its output, {0}, lies outside of the scene's folder; name it by -o if it is to be written</source>
        <translation>její výstup, {0}, leží mimo složku scény; má-li se zapsat, uveďte ho pomocí -o</translation>
    </message>
    <message>
        <source>its own lights leave much of what is seen in the dark; a background that lights was added</source>
        <translation>jeho vlastní světla nechávají velkou část záběru ve tmě; bylo přidáno svítící pozadí</translation>
    </message>
    <message>
        <source>its own lights reach nothing that is seen; other light was added</source>
        <translation>jeho vlastní světla nedosáhnou na nic z toho, co je vidět; bylo přidáno jiné světlo</translation>
    </message>
    <message>
        <source>its part {0} declares a document type, which 3MF forbids; export it again</source>
        <translation>jeho část {0} deklaruje typ dokumentu, což 3MF zakazuje; vyexportujte jej znovu</translation>
    </message>
    <message>
        <source>its part {0} is damaged; copy or export it again</source>
        <translation>jeho část {0} je poškozená; zkopírujte nebo vyexportujte jej znovu</translation>
    </message>
    <message>
        <source>its part {0} is larger than {1} bytes</source>
        <translation>jeho část {0} je větší než {1} bajtů</translation>
    </message>
    <message>
        <source>its part {0} is locked by a password; export it without</source>
        <translation>jeho část {0} je zamčena heslem; vyexportujte jej bez hesla</translation>
    </message>
    <message>
        <source>its part {0} is missing; copy or export it again</source>
        <translation>jeho část {0} chybí; zkopírujte nebo vyexportujte jej znovu</translation>
    </message>
    <message>
        <source>its pixels cannot be decoded</source>
        <translation>jeho pixely nelze dekódovat</translation>
    </message>
    <message>
        <source>its planes do not go with its number of symmetry, {0}; correct one of them</source>
        <translation>jeho roviny neodpovídají číslu souměrnosti {0}; opravte jedno z toho</translation>
    </message>
    <message>
        <source>its sides are out of range</source>
        <translation>jeho strany jsou mimo rozsah</translation>
    </message>
    <message>
        <source>its surfaces are not subdivided, as that would smear their textures along seams; export them subdivided</source>
        <translation>jeho plochy nejsou zjemněny, protože by se tím rozmazaly jejich textury podél švů; vyexportujte je zjemněné</translation>
    </message>
    <message>
        <source>its text is in UTF-16, which is not read; save it as UTF-8 in a text editor</source>
        <translation>jeho text je v UTF-16, které se nečte; uložte jej v textovém editoru jako UTF-8</translation>
    </message>
    <message>
        <source>its tilt is in a file of its own, {0}, which does not count</source>
        <translation>jeho sklon je ve zvláštním souboru {0}, ke kterému se nepřihlíží</translation>
    </message>
    <message>
        <source>its version is {0}, not {1}</source>
        <translation>jeho verze je {0}, ne {1}</translation>
    </message>
    <message>
        <source>its width is not above 0</source>
        <translation>jeho šířka není větší než 0</translation>
    </message>
    <message>
        <source>its width is not perpendicular to its direction</source>
        <translation>jeho šířka není kolmá na jeho směr</translation>
    </message>
    <message>
        <source>its width is out of range</source>
        <translation>jeho šířka je mimo rozsah</translation>
    </message>
    <message>
        <source>its {0} triangles take {1} MB of memory, more than the {2} MB that the importer may use; raise that (--memory-limit), else simplify the model</source>
        <translation>jeho trojúhelníky ({0}) zaberou {1} MB paměti, víc než {2} MB, které importér smí použít; zvyšte je (--memory-limit), nebo model zjednodušte</translation>
    </message>
    <message>
        <source>joints of its skins that are missing: {0}; what they would move goes with the others</source>
        <translation>chybějící klouby jeho koster: {0}; čím by pohybovaly, jde s ostatními</translation>
    </message>
    <message>
        <source>key</source>
        <translation>klíč</translation>
    </message>
    <message>
        <source>keys were released: nothing came for half a second</source>
        <translation>klávesy byly uvolněny: půl sekundy nic nepřišlo</translation>
    </message>
    <message>
        <source>lacquer</source>
        <translation>lak</translation>
    </message>
    <message>
        <source>leather</source>
        <translation>kůže</translation>
    </message>
    <message>
        <source>left out, since nothing of it is used: {0}</source>
        <translation>vynecháno, protože se z toho nic nepoužívá: {0}</translation>
    </message>
    <message>
        <source>libpng cannot be started</source>
        <translation>knihovnu libpng nelze spustit</translation>
    </message>
    <message>
        <source>libtiff cannot be started</source>
        <translation>libtiff nelze spustit</translation>
    </message>
    <message>
        <source>libtiff cannot write row {0}</source>
        <translation>libtiff nemůže zapsat řádek {0}</translation>
    </message>
    <message>
        <source>libtiff cannot write the directory</source>
        <translation>libtiff nemůže zapsat adresář</translation>
    </message>
    <message>
        <source>light is being measured already; wait for it, or give it up by 'measure stop'</source>
        <translation>světlo se už měří; počkejte, nebo měření zrušte příkazem 'measure stop'</translation>
    </message>
    <message>
        <source>light that passes through leaves and paper</source>
        <translation>světlo, které prochází listím a papírem</translation>
    </message>
    <message>
        <source>light {0} is given twice, or is a [[light]] as well</source>
        <translation>světlo {0} je uvedeno dvakrát nebo je zároveň v [[light]]</translation>
    </message>
    <message>
        <source>light {0} is left out: it is not a point, directional, spot or area light, or gives no light</source>
        <translation>světlo {0} je vynecháno: není bodové, směrové, kuželové ani plošné, nebo nesvítí</translation>
    </message>
    <message>
        <source>light {0} is named twice</source>
        <translation>světlo {0} je uvedeno dvakrát</translation>
    </message>
    <message>
        <source>light {0} off</source>
        <translation>světlo {0} zhasnuto</translation>
    </message>
    <message>
        <source>light {0} on</source>
        <translation>světlo {0} rozsvíceno</translation>
    </message>
    <message>
        <source>lights as the model's file brought them</source>
        <translation>světla tak, jak je přinesl soubor modelu</translation>
    </message>
    <message>
        <source>lights of a look</source>
        <translation>světla vzhledu</translation>
    </message>
    <message>
        <source>lights of the profile {0} shine to all sides alike: {1}</source>
        <translation>světla s profilem {0} svítí na všechny strany stejně: {1}</translation>
    </message>
    <message>
        <source>lights: they name more photometric files than a model may have</source>
        <translation>světla: jmenují víc fotometrických souborů, než model smí mít</translation>
    </message>
    <message>
        <source>line {0} of its part {1} is no XML ({2}); copy or export it again</source>
        <translation>řádek {0} jeho části {1} není XML ({2}); zkopírujte nebo vyexportujte jej znovu</translation>
    </message>
    <message>
        <source>linear colour goes into .exr, .hdr or .pfm only</source>
        <translation>lineární barvy lze uložit jen do .exr, .hdr nebo .pfm</translation>
    </message>
    <message>
        <source>linen</source>
        <translation>len</translation>
    </message>
    <message>
        <source>lookAt is where eye is; the camera needs a direction</source>
        <translation>lookAt je tam, kde eye; kamera potřebuje směr</translation>
    </message>
    <message>
        <source>lumens are those of a file; name it by file, or give an intensity</source>
        <translation>lumens patří k souboru; uveďte jej klíčem file, nebo zadejte intensity</translation>
    </message>
    <message>
        <source>lx is for directional lights; others give off lm or W</source>
        <translation>lx je pro směrová světla; ostatní mají lm nebo W</translation>
    </message>
    <message>
        <source>make a mesh of it</source>
        <translation>udělejte z toho síť</translation>
    </message>
    <message>
        <source>make a mesh of it (CloudCompare, MeshLab) and save that as PLY</source>
        <translation>udělejte z něj síť (CloudCompare, MeshLab) a tu uložte jako PLY</translation>
    </message>
    <message>
        <source>marble</source>
        <translation>mramor</translation>
    </message>
    <message>
        <source>material library {0} are missing; what it describes is plain grey</source>
        <translation>knihovny materiálů {0} chybí; co popisují, je šedé</translation>
    </message>
    <message>
        <source>material library {0} are not read, as they lie outside of the model's folder; what they describe is plain grey: put them beside the model</source>
        <translation>knihovny materiálů {0} se nečtou, protože leží mimo složku modelu; co popisují, je šedé: dejte je vedle modelu</translation>
    </message>
    <message>
        <source>material library {0} is missing; what it describes is plain grey</source>
        <translation>knihovna materiálů {0} chybí; co popisuje, je šedé</translation>
    </message>
    <message>
        <source>material library {0} is not read, as it lies outside of the model's folder; what it describes is plain grey: put it beside the model</source>
        <translation>knihovna materiálů {0} se nečte, protože leží mimo složku modelu; co popisuje, je šedé: dejte ji vedle modelu</translation>
    </message>
    <message>
        <source>material {0} is seen to emit light, but lights nothing</source>
        <translation>materiál {0} je vidět, jak svítí, ale nic neosvětluje</translation>
    </message>
    <message>
        <source>materials: there must be at least one</source>
        <translation>materials: musí být aspoň jeden</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>kov</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>zrcadlo</translation>
    </message>
    <message>
        <source>more follows behind the last intensity: '{0}'; the numbers of angles are wrong, or what follows is to be removed</source>
        <translation>za poslední svítivostí ještě něco je: „{0}“; počty úhlů jsou špatně, nebo je třeba to odstranit</translation>
    </message>
    <message>
        <source>more than {0} bytes</source>
        <translation>více než {0} bajtů</translation>
    </message>
    <message>
        <source>morph targets that do not fit their meshes and are left out: {0}</source>
        <translation>cílové tvary, které se nehodí ke svým sítím a jsou vynechány: {0}</translation>
    </message>
    <message>
        <source>name is empty; a bookmark is known by its name</source>
        <translation>name je prázdné; záložka se pozná podle jména</translation>
    </message>
    <message>
        <source>name is empty; a flight is known by its name</source>
        <translation>name je prázdné; let se pozná podle jména</translation>
    </message>
    <message>
        <source>name is empty; a variant is known by its name</source>
        <translation>name je prázdné; variantu určuje její jméno</translation>
    </message>
    <message>
        <source>name is empty; give {0}'s name or a pattern, "*"</source>
        <translation>name je prázdné; zadejte jméno ({0}) nebo vzor, "*"</translation>
    </message>
    <message>
        <source>names lights that the scene lacks ({0})</source>
        <translation>uvádí světla, která scéna nemá ({0})</translation>
    </message>
    <message>
        <source>names {0} by its absolute path, which no copy of the model would find; export it with relative ones, or make a .bsp of it by BSPBuilder and pack that</source>
        <translation>odkazuje na {0} absolutní cestou, kterou by žádná kopie modelu nenašla; exportujte ho s relativními cestami, nebo z něj udělejte programem BSPBuilder .bsp a zabalte ten</translation>
    </message>
    <message>
        <source>nets cannot be checked by this build, which is without OpenSSL; build the suite with libssl-dev</source>
        <translation>tento program je sestaven bez OpenSSL a sítě neumí ověřit; sestavte jej s libssl-dev</translation>
    </message>
    <message>
        <source>no environment map is shown</source>
        <translation>žádná mapa okolí se neukazuje</translation>
    </message>
    <message>
        <source>no folder can be made here: {0}; {1}</source>
        <translation>nelze tu vytvořit složku: {0}; {1}</translation>
    </message>
    <message>
        <source>no importer knows this format; convert it to glTF, OBJ, PLY or STL</source>
        <translation>tento formát neumí přečíst žádný importér; převeďte ho na glTF, OBJ, PLY nebo STL</translation>
    </message>
    <message>
        <source>no light reaches what is seen; one beside the viewer was added</source>
        <translation>na to, co je vidět, nedopadá žádné světlo; bylo přidáno jedno vedle pozorovatele</translation>
    </message>
    <message>
        <source>no material of the model has the number {0}</source>
        <translation>žádný materiál modelu nemá číslo {0}</translation>
    </message>
    <message>
        <source>no material of the model is named like "{0}"</source>
        <translation>žádný materiál modelu se nejmenuje jako "{0}"</translation>
    </message>
    <message>
        <source>no material of the model is {0}; 'materials' lists them</source>
        <translation>model nemá materiál {0}; vypíše je 'materials'</translation>
    </message>
    <message>
        <source>no page is open any more</source>
        <translation>už není otevřená žádná stránka</translation>
    </message>
    <message>
        <source>no part of the model has the number {0}</source>
        <translation>žádná část modelu nemá číslo {0}</translation>
    </message>
    <message>
        <source>no part of the model is named like "{0}"</source>
        <translation>žádná část modelu se nejmenuje jako "{0}"</translation>
    </message>
    <message>
        <source>no part of the model is {0}; 'parts' lists them</source>
        <translation>model nemá část {0}; vypíše je 'parts'</translation>
    </message>
    <message>
        <source>no parts of the model that show an image are named "{0}"; that environment is black</source>
        <translation>žádné části modelu, které ukazují obraz, se nejmenují "{0}"; tato mapa okolí je černá</translation>
    </message>
    <message>
        <source>no point of the grid lies over the floor below the viewpoint</source>
        <translation>žádný bod mřížky neleží nad podlahou pod stanovištěm</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>důvod neuveden</translation>
    </message>
    <message>
        <source>no server '{0}' is running; start one or name another instance</source>
        <translation>žádný server '{0}' neběží; spusťte ho, nebo zadejte jinou instanci</translation>
    </message>
    <message>
        <source>no server '{0}' runs</source>
        <translation>žádný server '{0}' neběží</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>takový soubor není</translation>
    </message>
    <message>
        <source>no temporary file: {0}</source>
        <translation>nelze vytvořit dočasný soubor: {0}</translation>
    </message>
    <message>
        <source>no variant is active; name the one to be updated</source>
        <translation>žádná varianta není zobrazena; pojmenujte tu, která se má aktualizovat</translation>
    </message>
    <message>
        <source>node {0} has children behind the last node</source>
        <translation>uzel {0} má potomky až za posledním uzlem</translation>
    </message>
    <message>
        <source>node {0} has children out of order</source>
        <translation>uzel {0} má potomky ve špatném pořadí</translation>
    </message>
    <message>
        <source>node {0} has references behind the last one</source>
        <translation>uzel {0} má odkazy až za posledním</translation>
    </message>
    <message>
        <source>node {0} has references out of order</source>
        <translation>uzel {0} má odkazy ve špatném pořadí</translation>
    </message>
    <message>
        <source>node {0} has references that do not ascend</source>
        <translation>uzel {0} má odkazy, které nejdou vzestupně</translation>
    </message>
    <message>
        <source>node {0} is part of no tree</source>
        <translation>uzel {0} nepatří do stromu</translation>
    </message>
    <message>
        <source>node {0} is too deep</source>
        <translation>uzel {0} je příliš hluboko</translation>
    </message>
    <message>
        <source>node {0} lacks triangle {1}, which reaches into it</source>
        <translation>v uzlu {0} chybí trojúhelník {1}, který do něj zasahuje</translation>
    </message>
    <message>
        <source>node {0} refers to a triangle that does not exist</source>
        <translation>uzel {0} odkazuje na trojúhelník, který neexistuje</translation>
    </message>
    <message>
        <source>node {0} refers to triangle {1}, which lies outside of it</source>
        <translation>uzel {0} odkazuje na trojúhelník {1}, který leží mimo něj</translation>
    </message>
    <message>
        <source>node {0} splits outside of its cell</source>
        <translation>uzel {0} dělí mimo svou buňku</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádné</translation>
    </message>
    <message>
        <source>normals: element {0} is not of unit length</source>
        <translation>normals: prvek {0} nemá jednotkovou délku</translation>
    </message>
    <message>
        <source>not an image of a known format; convert it to PNG, JPEG or EXR</source>
        <translation>není to obraz ve známém formátu; převeďte ho na PNG, JPEG nebo EXR</translation>
    </message>
    <message>
        <source>not enough memory</source>
        <translation>nedostatek paměti</translation>
    </message>
    <message>
        <source>not enough memory for frames of {0} at these settings; back to those of the last frame, {1}</source>
        <translation>na snímky {0} s tímto nastavením není dost paměti; zpět k nastavení posledního snímku, {1}</translation>
    </message>
    <message>
        <source>not enough memory for frames of {0} x {1}; ask for a lower resolution</source>
        <translation>na snímky {0} x {1} není dost paměti; zvolte menší rozlišení</translation>
    </message>
    <message>
        <source>not enough memory for this image</source>
        <translation>na tento obraz není dost paměti</translation>
    </message>
    <message>
        <source>not enough memory; make the image or the model smaller, or use a machine with more</source>
        <translation>nedostatek paměti; zmenšete obraz nebo model, nebo použijte počítač, který jí má víc</translation>
    </message>
    <message>
        <source>not written, since frames are missing</source>
        <translation>nezapsán, protože chybějí snímky</translation>
    </message>
    <message>
        <source>not written, since it could not be read back: {0}</source>
        <translation>nezapsáno, protože by to nešlo znovu přečíst: {0}</translation>
    </message>
    <message>
        <source>not written: the model cannot be used ({0}); repair the model's file</source>
        <translation>nezapsáno: model nelze použít ({0}); opravte soubor modelu</translation>
    </message>
    <message>
        <source>not written: {0}</source>
        <translation>nezapsáno: {0}</translation>
    </message>
    <message>
        <source>nothing differs from the base; change materials, parts, lights or the sky first</source>
        <translation>od základu se nic neliší; nejprve změňte materiály, součásti, světla nebo oblohu</translation>
    </message>
    <message>
        <source>nothing is being recorded</source>
        <translation>nic se nenahrává</translation>
    </message>
    <message>
        <source>nothing is below: walking on a floor at the model's lowest point that is not seen</source>
        <translation>dole nic není: chodíte po neviditelné podlaze v nejnižším bodě modelu</translation>
    </message>
    <message>
        <source>nothing is cut there, and nothing is beyond: there is nothing to draw</source>
        <translation>nic tam není rozříznuto a nic není za řezem: není co kreslit</translation>
    </message>
    <message>
        <source>nothing of the model is seen there</source>
        <translation>z modelu tam není nic vidět</translation>
    </message>
    <message>
        <source>numbers {0} and {1}</source>
        <translation>čísla {0} a {1}</translation>
    </message>
    <message>
        <source>numbers {0} to {1}</source>
        <translation>čísla {0} až {1}</translation>
    </message>
    <message>
        <source>oak</source>
        <translation>dub</translation>
    </message>
    <message>
        <source>of an unknown name</source>
        <translation>neznámého jména</translation>
    </message>
    <message>
        <source>of its {0} MB hardly any were ever written; copy or export it again</source>
        <translation>z jeho {0} MB skoro nic nebylo zapsáno; zkopírujte nebo exportujte ho znovu</translation>
    </message>
    <message>
        <source>of levels of detail (LOD) the first is shown</source>
        <translation>z úrovní detailu (LOD) se zobrazuje první</translation>
    </message>
    <message>
        <source>only a light of the kind ies has a file and lumens</source>
        <translation>file a lumens má jen světlo druhu ies</translation>
    </message>
    <message>
        <source>only number {0}</source>
        <translation>jen číslo {0}</translation>
    </message>
    <message>
        <source>only texts in quotes</source>
        <translation>jen texty v uvozovkách</translation>
    </message>
    <message>
        <source>only the driver hands over, to one with a driver's link</source>
        <translation>předat řízení může jen ten, kdo řídí, a jen někomu s odkazem k řízení</translation>
    </message>
    <message>
        <source>only the driver may do that</source>
        <translation>to smí jen ten, kdo řídí</translation>
    </message>
    <message>
        <source>only the driver may do that; ask to drive first</source>
        <translation>to smí jen ten, kdo řídí; nejdřív požádejte o řízení</translation>
    </message>
    <message>
        <source>only true and false</source>
        <translation>jen true a false</translation>
    </message>
    <message>
        <source>only whole numbers from {0} to {1}</source>
        <translation>jen celá čísla od {0} do {1}</translation>
    </message>
    <message>
        <source>orthographic cameras of this Collada file become perspective ones</source>
        <translation>ortografické kamery tohoto souboru Collada se mění v perspektivní</translation>
    </message>
    <message>
        <source>others are being found out; ask again when they are there</source>
        <translation>jiné se právě zjišťují; zeptejte se znovu, až budou hotové</translation>
    </message>
    <message>
        <source>pages give no {0}</source>
        <translation>stránky neposílají {0}</translation>
    </message>
    <message>
        <source>parts names no part; give at least one</source>
        <translation>parts neuvádí žádnou část; zadejte aspoň jednu</translation>
    </message>
    <message>
        <source>parts: a name lies outside of the strings</source>
        <translation>parts: některé jméno leží mimo oddíl strings</translation>
    </message>
    <message>
        <source>parts: one names a triangle that does not exist</source>
        <translation>parts: některá část uvádí trojúhelník, který neexistuje</translation>
    </message>
    <message>
        <source>parts: two overlap, or they do not ascend</source>
        <translation>parts: dvě části se překrývají nebo nejdou vzestupně</translation>
    </message>
    <message>
        <source>paths are lit by {0} lights, {1} emissive triangles</source>
        <translation>cesty osvětlují světla ({0}) a svítící trojúhelníky ({1})</translation>
    </message>
    <message>
        <source>paths are lit by {0} lights, {1} emissive triangles, and the surroundings</source>
        <translation>cesty osvětlují světla ({0}), svítící trojúhelníky ({1}) a okolí</translation>
    </message>
    <message>
        <source>paths in brackets</source>
        <translation>cesty v hranatých závorkách</translation>
    </message>
    <message>
        <source>perspective and orthographic views cannot be in one flight</source>
        <translation>pohledy s perspektivou a bez ní nemohou být v jednom letu</translation>
    </message>
    <message>
        <source>plastic</source>
        <translation>plast</translation>
    </message>
    <message>
        <source>playing ended: {0}</source>
        <translation>přehrávání skončilo: {0}</translation>
    </message>
    <message>
        <source>point</source>
        <translation>bodové</translation>
    </message>
    <message>
        <source>polished</source>
        <translation>leštěné</translation>
    </message>
    <message>
        <source>pose is {0}; it must be "rest", "first" or the name or number of an animation with @ and seconds behind it</source>
        <translation>pose je {0}; musí to být "rest", "first" nebo název či číslo animace, za nímž stojí @ a sekundy</translation>
    </message>
    <message>
        <source>positions in brackets</source>
        <translation>polohy v závorkách</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>předvolba</translation>
    </message>
    <message>
        <source>reading it takes more than the {0} MB of memory that the importer may use; raise that (--memory-limit) if the model and its images are that large, else simplify it or export it again</source>
        <translation>čtení potřebuje více než {0} MB paměti, které smí import použít; zvyšte tuto mez (--memory-limit), pokud jsou model a jeho obrázky tak velké, jinak jej zjednodušte nebo vyexportujte znovu</translation>
    </message>
    <message>
        <source>ready: instance '{0}', {1}, {2} x {3}</source>
        <translation>připraven: instance '{0}', {1}, {2} x {3}</translation>
    </message>
    <message>
        <source>record {0} makes no sense</source>
        <translation>záznam {0} nedává smysl</translation>
    </message>
    <message>
        <source>recording ended: {0}</source>
        <translation>nahrávání skončilo: {0}</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>obdélníkové</translation>
    </message>
    <message>
        <source>reference {0} is part of no leaf</source>
        <translation>odkaz {0} nepatří do žádného listu</translation>
    </message>
    <message>
        <source>right is zero or along direction; give where the width of the light points to, or C = 0 of a luminaire</source>
        <translation>right je nulový nebo podél direction; uveďte, kam míří šířka světla nebo C = 0 svítidla</translation>
    </message>
    <message>
        <source>rooms: {0}, {1} m2 together</source>
        <translation>místnosti: {0}, dohromady {1} m2</translation>
    </message>
    <message>
        <source>rubber</source>
        <translation>guma</translation>
    </message>
    <message>
        <source>section lights: one names a luminaire that is not there</source>
        <translation>sekce lights: jedno jmenuje svítidlo, které tam není</translation>
    </message>
    <message>
        <source>section nodes belongs to no tree</source>
        <translation>oddíl nodes nepatří k žádnému stromu</translation>
    </message>
    <message>
        <source>section nodes: {0}</source>
        <translation>oddíl nodes: {0}</translation>
    </message>
    <message>
        <source>section {0}</source>
        <translation>oddíl {0}</translation>
    </message>
    <message>
        <source>section {0} begins at the wrong place</source>
        <translation>oddíl {0} začíná na špatném místě</translation>
    </message>
    <message>
        <source>section {0} ends behind the end of the file</source>
        <translation>oddíl {0} končí až za koncem souboru</translation>
    </message>
    <message>
        <source>section {0} has bytes before it that are not zero</source>
        <translation>před oddílem {0} jsou nenulové bajty</translation>
    </message>
    <message>
        <source>section {0} has elements of the wrong size</source>
        <translation>oddíl {0} má prvky špatné velikosti</translation>
    </message>
    <message>
        <source>section {0} is no list of distributions</source>
        <translation>sekce {0} není seznam rozložení svítivosti</translation>
    </message>
    <message>
        <source>section {0} is no text</source>
        <translation>oddíl {0} není text</translation>
    </message>
    <message>
        <source>seen takes numbers from 0 to 1, not '{0}'</source>
        <translation>seen bere čísla od 0 do 1, ne '{0}'</translation>
    </message>
    <message>
        <source>server '{0}' (process {1}) is of another version ({2}) than this program ({3}); use programs of one version</source>
        <translation>server '{0}' (proces {1}) má jinou verzi ({2}) než tento program ({3}); použijte programy stejné verze</translation>
    </message>
    <message>
        <source>server '{0}' has {1} clients, and takes no more; end one</source>
        <translation>server '{0}' má {1} klientů a víc jich nepřijme; některého ukončete</translation>
    </message>
    <message>
        <source>server '{0}' is already running (process {1}); stop it or name another instance</source>
        <translation>server '{0}' už běží (proces {1}); zastavte ho, nebo zadejte jinou instanci</translation>
    </message>
    <message>
        <source>server '{0}' is already running; stop it or name another instance</source>
        <translation>server '{0}' už běží; zastavte ho, nebo zadejte jinou instanci</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>nastavení</translation>
    </message>
    <message>
        <source>several parts are called so; give the number of one</source>
        <translation>tak se jmenuje několik částí; zadejte číslo jedné</translation>
    </message>
    <message>
        <source>shading: an element names a normal or a material that does not exist</source>
        <translation>shading: některý prvek uvádí normálu nebo materiál, které neexistují</translation>
    </message>
    <message>
        <source>shading: there must be one element per triangle</source>
        <translation>shading: na každý trojúhelník musí být jeden prvek</translation>
    </message>
    <message>
        <source>shared memory cannot be locked: {0}</source>
        <translation>sdílenou paměť nelze zamknout: {0}</translation>
    </message>
    <message>
        <source>shared memory {0}: belongs to another user or is open to others; remove it or name another instance</source>
        <translation>sdílená paměť {0}: patří jinému uživateli nebo je přístupná ostatním; odstraňte ji, nebo zadejte jinou instanci</translation>
    </message>
    <message>
        <source>shared memory {0}: cannot be opened: {1}</source>
        <translation>sdílená paměť {0}: nelze otevřít: {1}</translation>
    </message>
    <message>
        <source>shared memory {0}: cannot be opened: {1}; remove it or name another instance</source>
        <translation>sdílená paměť {0}: nelze otevřít: {1}; odstraňte ji, nebo zadejte jinou instanci</translation>
    </message>
    <message>
        <source>shared memory {0}: cannot be renamed: {1}</source>
        <translation>sdílená paměť {0}: nelze přejmenovat: {1}</translation>
    </message>
    <message>
        <source>shared memory {0}: is not a segment; remove it or name another instance</source>
        <translation>sdílená paměť {0}: není to segment; odstraňte ji, nebo zadejte jinou instanci</translation>
    </message>
    <message>
        <source>shared memory {0}: the name is taken; remove it or name another instance</source>
        <translation>sdílená paměť {0}: jméno je obsazené; odstraňte ji, nebo zadejte jinou instanci</translation>
    </message>
    <message>
        <source>shared memory {0}: {1}</source>
        <translation>sdílená paměť {0}: {1}</translation>
    </message>
    <message>
        <source>shared memory: needs {0}, {1} has {2} left; free some (in a container: --shm-size) or ask for a lower resolution</source>
        <translation>sdílená paměť: je potřeba {0}, v {1} zbývá {2}; nějakou uvolněte (v kontejneru: --shm-size), nebo zvolte nižší rozlišení</translation>
    </message>
    <message>
        <source>sizes: a section has more than 2^32 elements</source>
        <translation>velikosti: některý oddíl má víc než 2^32 prvků</translation>
    </message>
    <message>
        <source>so much light cannot be counted</source>
        <translation>tolik světla nelze vyjádřit</translation>
    </message>
    <message>
        <source>some of the light of this scene has no absolute unit ({0}), so that false colours are true of the rest alone</source>
        <translation>část světla této scény nemá absolutní jednotku ({0}), takže nepravé barvy platí jen pro ostatní světlo</translation>
    </message>
    <message>
        <source>some parts that are cut are open: they have lines and no area</source>
        <translation>některé rozříznuté části jsou otevřené: mají čáry, ale žádnou plochu</translation>
    </message>
    <message>
        <source>some settings are locked; reset others one by one</source>
        <translation>některá nastavení jsou zamčená; ostatní vraťte po jednom</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>kulové</translation>
    </message>
    <message>
        <source>spot</source>
        <translation>kuželové</translation>
    </message>
    <message>
        <source>steel</source>
        <translation>ocel</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>zastaveno</translation>
    </message>
    <message>
        <source>stopped; try again</source>
        <translation>zastaveno; zkuste to znovu</translation>
    </message>
    <message>
        <source>stopped; what was learned is kept, and the same command goes on</source>
        <translation>zastaveno; co bylo zjištěno, zůstává uloženo a stejný příkaz pokračuje</translation>
    </message>
    <message>
        <source>storey {0} of {1}: its floor is at {2}, the cut at {3}</source>
        <translation>podlaží {0} z {1}: podlaha je ve výšce {2}, řez ve výšce {3}</translation>
    </message>
    <message>
        <source>strings: the first name must be empty</source>
        <translation>strings: první jméno musí být prázdné</translation>
    </message>
    <message>
        <source>strings: the last name does not end</source>
        <translation>strings: poslední jméno nekončí</translation>
    </message>
    <message>
        <source>such files</source>
        <translation>takové soubory</translation>
    </message>
    <message>
        <source>surfaces that emit as the model's file says</source>
        <translation>povrchy, které svítí podle souboru modelu</translation>
    </message>
    <message>
        <source>switches {0} light, but the scene has {1}</source>
        <translation>přepíná světla ({0}), ale scéna jich má {1}</translation>
    </message>
    <message>
        <source>switches {0} lights, but the scene has {1}</source>
        <translation>přepíná světla ({0}), ale scéna jich má {1}</translation>
    </message>
    <message>
        <source>tables, [[{0}]]</source>
        <translation>tabulky, [[{0}]]</translation>
    </message>
    <message>
        <source>texcoords: there must be none or one per normal</source>
        <translation>texcoords: nesmí být žádné, nebo musí být jedny na každou normálu</translation>
    </message>
    <message>
        <source>texcoordsets: there must be none or as many for each normal</source>
        <translation>texcoordsets: musí jich být nula, nebo pro každou normálu stejně</translation>
    </message>
    <message>
        <source>text</source>
        <translation>text</translation>
    </message>
    <message>
        <source>text in quotes</source>
        <translation>text v uvozovkách</translation>
    </message>
    <message>
        <source>texts in brackets</source>
        <translation>texty v hranatých závorkách</translation>
    </message>
    <message>
        <source>texture {0} is empty; its material is plain</source>
        <translation>textura {0} je prázdná; její materiál je jednobarevný</translation>
    </message>
    <message>
        <source>texture {0} is missing; its material is plain</source>
        <translation>chybí textura {0}; její materiál je jednobarevný</translation>
    </message>
    <message>
        <source>texture {0}; its material is plain</source>
        <translation>textura {0}; její materiál je jednobarevný</translation>
    </message>
    <message>
        <source>textures that are clamped or mirrored in this Collada file repeat instead</source>
        <translation>textury, které tento soubor Collada ořezává nebo zrcadlí, se místo toho opakují</translation>
    </message>
    <message>
        <source>the .pdf cannot be made: error {0} of libharu</source>
        <translation>.pdf nelze vytvořit: chyba {0} knihovny libharu</translation>
    </message>
    <message>
        <source>the angle {0} follows {1}; angles ascend, by a thousandth of a degree or more</source>
        <translation>po úhlu {1} je {0}; úhly rostou aspoň o tisícinu stupně</translation>
    </message>
    <message>
        <source>the area or volume of a measure is a number from 0 to 1e36</source>
        <translation>plocha nebo objem míry je číslo od 0 do 1e36</translation>
    </message>
    <message>
        <source>the background</source>
        <translation>pozadí</translation>
    </message>
    <message>
        <source>the ballast factor</source>
        <translation>činitel předřadníku</translation>
    </message>
    <message>
        <source>the bridge ends</source>
        <translation>RTBridge končí</translation>
    </message>
    <message>
        <source>the camera needs a direction to look in</source>
        <translation>kamera potřebuje směr pohledu</translation>
    </message>
    <message>
        <source>the candela multiplier</source>
        <translation>násobitel svítivostí</translation>
    </message>
    <message>
        <source>the checksum of its part {0} is wrong</source>
        <translation>nesouhlasí kontrolní součet jeho části {0}</translation>
    </message>
    <message>
        <source>the coat of varnish of material {0} is even: the mean of its textures</source>
        <translation>lak materiálu {0} je všude stejný: průměr jeho textur</translation>
    </message>
    <message>
        <source>the colour of the light sources</source>
        <translation>barva zdrojů</translation>
    </message>
    <message>
        <source>the colours of thin films</source>
        <translation>barvy tenkých vrstev</translation>
    </message>
    <message>
        <source>the colours that glass parts light into</source>
        <translation>barvy, na které sklo rozkládá světlo</translation>
    </message>
    <message>
        <source>the command ends with a backslash</source>
        <translation>příkaz končí zpětným lomítkem</translation>
    </message>
    <message>
        <source>the command is empty</source>
        <translation>příkaz je prázdný</translation>
    </message>
    <message>
        <source>the conversion factor of intensities</source>
        <translation>převodní činitel svítivostí</translation>
    </message>
    <message>
        <source>the coordinates of all of its {0} points are no numbers or beyond 1e12</source>
        <translation>souřadnice všech jeho {0} bodů nejsou čísla nebo přesahují 1e12</translation>
    </message>
    <message>
        <source>the direction is zero; give where the light shines to</source>
        <translation>směr je nulový; zadejte, kam světlo svítí</translation>
    </message>
    <message>
        <source>the direction that is up must be another one than that to look in</source>
        <translation>směr nahoru musí být jiný než směr pohledu</translation>
    </message>
    <message>
        <source>the direction to the sun is not zero</source>
        <translation>směr ke slunci nesmí být nulový</translation>
    </message>
    <message>
        <source>the distance of angles</source>
        <translation>rozestup úhlů</translation>
    </message>
    <message>
        <source>the distance of planes</source>
        <translation>rozestup rovin</translation>
    </message>
    <message>
        <source>the downward flux fraction</source>
        <translation>podíl toku dolů</translation>
    </message>
    <message>
        <source>the drawing takes more than {0} sheets of {1}; take a smaller scale</source>
        <translation>výkres zabere víc než {0} listů {1}; zvolte menší měřítko</translation>
    </message>
    <message>
        <source>the drawing takes {0} sheets of {1}; write a .pdf, or take a larger paper or a smaller scale</source>
        <translation>výkres zabere {0} listů {1}; zapište .pdf, nebo zvolte větší papír či menší měřítko</translation>
    </message>
    <message>
        <source>the drawn-out highlights of brushed metal</source>
        <translation>protažené odlesky kartáčovaného kovu</translation>
    </message>
    <message>
        <source>the driver is asked</source>
        <translation>žádost dostal ten, kdo řídí</translation>
    </message>
    <message>
        <source>the environment {0}</source>
        <translation>prostředí {0}</translation>
    </message>
    <message>
        <source>the exact kd-tree is in use; it took {0} s</source>
        <translation>používá se přesný kd-strom; trval {0} s</translation>
    </message>
    <message>
        <source>the exposure of a key frame is above 0 and finite</source>
        <translation>expozice klíčového snímku je větší než 0 a konečná</translation>
    </message>
    <message>
        <source>the faces of a cube are squares of one size, here {0} a side</source>
        <translation>stěny krychle jsou stejně velké čtverce, zde o straně {0}</translation>
    </message>
    <message>
        <source>the field of view is more than 0 and less than 180 degrees</source>
        <translation>zorný úhel je víc než 0 a méně než 180 stupňů</translation>
    </message>
    <message>
        <source>the field of view is not in 0..180 degrees</source>
        <translation>zorné pole není v rozsahu 0..180 stupňů</translation>
    </message>
    <message>
        <source>the file ends in the middle of a line or a list; complete it</source>
        <translation>soubor končí uprostřed řádku nebo seznamu; doplňte ho</translation>
    </message>
    <message>
        <source>the file ends too early: it is damaged or was not copied completely</source>
        <translation>soubor končí příliš brzy: je poškozený, nebo nebyl zkopírován celý</translation>
    </message>
    <message>
        <source>the file ends where {0} should follow; it was cut off, so get it again</source>
        <translation>soubor končí tam, kde má následovat {0}; je useknutý, opatřete si jej znovu</translation>
    </message>
    <message>
        <source>the file has its corners in numbers that are {0} units coarse so far from its zero; export it nearer to zero, or in a format with more digits (PLY of doubles, OBJ)</source>
        <translation>soubor má rohy v číslech, která jsou tak daleko od jeho nuly hrubá na {0} jednotek; exportujte jej blíže k nule nebo do formátu s více číslicemi (PLY s doubles, OBJ)</translation>
    </message>
    <message>
        <source>the file is cut off</source>
        <translation>soubor je neúplný</translation>
    </message>
    <message>
        <source>the file is damaged (its checksum differs)</source>
        <translation>soubor je poškozený (nesouhlasí kontrolní součet)</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>soubor je prázdný</translation>
    </message>
    <message>
        <source>the file is longer than it should be</source>
        <translation>soubor je delší, než má být</translation>
    </message>
    <message>
        <source>the file is of another version of this suite</source>
        <translation>soubor je z jiné verze této sady programů</translation>
    </message>
    <message>
        <source>the file is too short for the {0} pixels that its header names</source>
        <translation>soubor je příliš krátký na {0} pixelů, které udává jeho hlavička</translation>
    </message>
    <message>
        <source>the file is truncated</source>
        <translation>soubor je useknutý</translation>
    </message>
    <message>
        <source>the file says so</source>
        <translation>říká to soubor</translation>
    </message>
    <message>
        <source>the flight ends after {0} seconds; give two times before that, the earlier one first</source>
        <translation>let končí po {0} sekundách; zadejte dva časy před tím, dřívější první</translation>
    </message>
    <message>
        <source>the flight has an even speed; 'flight timing NAME times' gives it times</source>
        <translation>let má stálou rychlost; časy mu dá 'flight timing NAME times'</translation>
    </message>
    <message>
        <source>the flight has no key frame</source>
        <translation>let nemá žádný klíčový snímek</translation>
    </message>
    <message>
        <source>the flight has {0} key frames, and no number {1}</source>
        <translation>let má {0} klíčových snímků, a číslo {1} mezi nimi není</translation>
    </message>
    <message>
        <source>the flight is too long for an answer; 'export scene' writes it</source>
        <translation>let je na odpověď příliš dlouhý; zapíše ho 'export scene'</translation>
    </message>
    <message>
        <source>the flights have more than {0} key frames together; leave some out</source>
        <translation>lety mají dohromady více než {0} klíčových snímků; některé vynechte</translation>
    </message>
    <message>
        <source>the flights would have more than {0} key frames together; remove some</source>
        <translation>lety by měly dohromady více než {0} klíčových snímků; některé odstraňte</translation>
    </message>
    <message>
        <source>the folder cannot be made: {0}</source>
        <translation>složku nelze vytvořit: {0}</translation>
    </message>
    <message>
        <source>the folder for temporary files: {0}</source>
        <translation>složka pro dočasné soubory: {0}</translation>
    </message>
    <message>
        <source>the grid would have more than {0} points; give a larger SPACING</source>
        <translation>mřížka by měla více než {0} bodů; zadejte větší SPACING</translation>
    </message>
    <message>
        <source>the groups that it uses again (USE) come to more than {0} MB of text; export it with fewer of them</source>
        <translation>skupiny, které používá znovu (USE), mají dohromady víc než {0} MB textu; exportujte ho s menším počtem</translation>
    </message>
    <message>
        <source>the image cannot be drawn: {0}</source>
        <translation>obrázek nelze nakreslit: {0}</translation>
    </message>
    <message>
        <source>the image has {0} x {1} pixels; {2}</source>
        <translation>obraz má {0} x {1} pixelů; {2}</translation>
    </message>
    <message>
        <source>the image inside the model is empty</source>
        <translation>obraz uvnitř modelu je prázdný</translation>
    </message>
    <message>
        <source>the image inside the model is too large</source>
        <translation>obraz uvnitř modelu je příliš velký</translation>
    </message>
    <message>
        <source>the image is empty ({0} x {1} pixels)</source>
        <translation>obraz je prázdný ({0} x {1} pixelů)</translation>
    </message>
    <message>
        <source>the image is too large ({0} x {1} pixels); the most is {2} a side and {3} megapixels</source>
        <translation>obraz je příliš velký ({0} x {1} pixelů); nejvíc může mít {2} na stranu a {3} megapixelů</translation>
    </message>
    <message>
        <source>the images of multiproperties lie on them in different ways; all are laid as the lowest one is</source>
        <translation>obrázky v multiproperties leží různě; všechny jsou položeny jako nejspodnější z nich</translation>
    </message>
    <message>
        <source>the import was stopped</source>
        <translation>import byl zastaven</translation>
    </message>
    <message>
        <source>the importer crashed (signal {0}, {1}) while reading it</source>
        <translation>importér při jeho čtení havaroval (signál {0}, {1})</translation>
    </message>
    <message>
        <source>the importer failed (exit code {0}: {1})</source>
        <translation>importér selhal (návratový kód {0}) a vypsal anglicky: „{1}“</translation>
    </message>
    <message>
        <source>the importer got no further for {0} seconds and was ended; raise the time limit when the model is that large, else simplify it or export it again</source>
        <translation>importér se {0} s nedostal dál a byl ukončen; je-li model opravdu tak velký, zvyšte časový limit, jinak ho zjednodušte nebo exportujte znovu</translation>
    </message>
    <message>
        <source>the importer handed over a model that cannot be used ({0})</source>
        <translation>importér předal model, který nelze použít ({0})</translation>
    </message>
    <message>
        <source>the importer program is missing; install it beside this program or name it in RT_IMPORTER</source>
        <translation>chybí program importéru; nainstalujte ho vedle tohoto programu, nebo ho uveďte v RT_IMPORTER</translation>
    </message>
    <message>
        <source>the inner angle must be below the outer one, by enough to tell them apart</source>
        <translation>vnitřní úhel musí být znatelně menší než vnější</translation>
    </message>
    <message>
        <source>the input is too large: {0}</source>
        <translation>vstup je příliš velký: {0}</translation>
    </message>
    <message>
        <source>the kd-tree of the visible parts is in use; it took {0} s</source>
        <translation>používá se kd-strom viditelných částí; trval {0} s</translation>
    </message>
    <message>
        <source>the kd-tree: {0}</source>
        <translation>kd-strom: {0}</translation>
    </message>
    <message>
        <source>the key {0} is missing here; add it</source>
        <translation>chybí tu klíč {0}; přidejte ho</translation>
    </message>
    <message>
        <source>the kind of light sources</source>
        <translation>druh zdrojů</translation>
    </message>
    <message>
        <source>the kind of luminaire</source>
        <translation>druh svítidla</translation>
    </message>
    <message>
        <source>the largest value of a PNM must lie in 1..65535</source>
        <translation>největší hodnota v PNM musí být 1 až 65535</translation>
    </message>
    <message>
        <source>the last edit is not yours</source>
        <translation>poslední úprava není vaše</translation>
    </message>
    <message>
        <source>the last edit is still under way</source>
        <translation>poslední úprava ještě probíhá</translation>
    </message>
    <message>
        <source>the last section does not end with the file</source>
        <translation>poslední oddíl nekončí s koncem souboru</translation>
    </message>
    <message>
        <source>the layer {0} has no bias for each output</source>
        <translation>vrstva {0} nemá posun (bias) pro každý výstup</translation>
    </message>
    <message>
        <source>the layer {0} has {1} inputs, not {2}</source>
        <translation>vrstva {0} má {1} vstupů, ne {2}</translation>
    </message>
    <message>
        <source>the layer {0} is missing</source>
        <translation>chybí vrstva {0}</translation>
    </message>
    <message>
        <source>the layer {0} is no convolution of 3 x 3</source>
        <translation>vrstva {0} není konvoluce 3 x 3</translation>
    </message>
    <message>
        <source>the light of its surroundings</source>
        <translation>světlo jeho okolí</translation>
    </message>
    <message>
        <source>the light of this scene has no absolute unit ({0}), so that false colours tell what is brighter than what, but no cd/m2 or lux</source>
        <translation>světlo této scény nemá absolutní jednotku ({0}), takže nepravé barvy říkají, co je jasnější než co, ale žádné cd/m2 ani luxy</translation>
    </message>
    <message>
        <source>the light output ratio</source>
        <translation>účinnost svítidla</translation>
    </message>
    <message>
        <source>the lights were edited</source>
        <translation>světla byla upravena</translation>
    </message>
    <message>
        <source>the list has become shorter while it was followed; start again</source>
        <translation>seznam se během sledování zkrátil; začněte znovu</translation>
    </message>
    <message>
        <source>the list has no end mark, but did not grow any more; it is taken as complete</source>
        <translation>seznam nemá značku konce, ale už se neprodlužoval; považuje se za úplný</translation>
    </message>
    <message>
        <source>the list names no camera</source>
        <translation>seznam neuvádí žádnou kameru</translation>
    </message>
    <message>
        <source>the list of what it holds, at its end, is missing or damaged; copy or export it again</source>
        <translation>seznam obsahu na jeho konci chybí nebo je poškozený; zkopírujte nebo vyexportujte jej znovu</translation>
    </message>
    <message>
        <source>the lumens of a light source</source>
        <translation>lumeny zdroje</translation>
    </message>
    <message>
        <source>the lumens of the light sources</source>
        <translation>lumeny zdrojů</translation>
    </message>
    <message>
        <source>the maker</source>
        <translation>výrobce</translation>
    </message>
    <message>
        <source>the measurement was stopped</source>
        <translation>měření bylo zastaveno</translation>
    </message>
    <message>
        <source>the model has more profiles than are kept, {0} or {1} numbers in all</source>
        <translation>model má víc profilů, než kolik se uchovává: {0}, nebo celkem {1} čísel</translation>
    </message>
    <message>
        <source>the model has no luminaire {0}; light {1} shines to all sides alike</source>
        <translation>model nemá svítidlo {0}; světlo {1} svítí na všechny strany stejně</translation>
    </message>
    <message>
        <source>the model has no such material; 'materials' lists them</source>
        <translation>model takový materiál nemá; vypíše je 'materials'</translation>
    </message>
    <message>
        <source>the model has no such part; 'parts' lists them</source>
        <translation>model takovou část nemá; vypíše je 'parts'</translation>
    </message>
    <message>
        <source>the model is too small to walk: it is {0} m high; 'units' says how large it is</source>
        <translation>model je na chození příliš malý: má na výšku {0} m; jak je velký, říká 'units'</translation>
    </message>
    <message>
        <source>the name of a flight is UTF-8 of at most {0} bytes, without control characters</source>
        <translation>jméno letu je UTF-8 o nejvýše {0} bajtech, bez řídicích znaků</translation>
    </message>
    <message>
        <source>the name of a light is a text in UTF-8</source>
        <translation>jméno světla je text v UTF-8</translation>
    </message>
    <message>
        <source>the name of a measure is UTF-8 of at most {0} bytes</source>
        <translation>název míry je UTF-8 o nejvýše {0} bajtech</translation>
    </message>
    <message>
        <source>the name of a variant is UTF-8 of at most {0} bytes, without control characters</source>
        <translation>jméno varianty je text v UTF-8 dlouhý nejvýše {0} bajtů, bez řídicích znaků</translation>
    </message>
    <message>
        <source>the name of an author is UTF-8 of at most {0} characters, without control characters</source>
        <translation>jméno autora je UTF-8 o nejvýše {0} znacích, bez řídicích znaků</translation>
    </message>
    <message>
        <source>the name of an author is a text</source>
        <translation>jméno autora je text</translation>
    </message>
    <message>
        <source>the net has {0} outputs, not 3</source>
        <translation>síť má {0} výstupů, ne 3</translation>
    </message>
    <message>
        <source>the normal is not zero</source>
        <translation>normála nesmí být nulová</translation>
    </message>
    <message>
        <source>the normal of the measure is zero or too large</source>
        <translation>normála míry je nulová nebo příliš velká</translation>
    </message>
    <message>
        <source>the normal of the section is zero or too large; give the side that is taken away</source>
        <translation>normála řezu je nulová nebo příliš dlouhá; uveďte stranu, která se odebírá</translation>
    </message>
    <message>
        <source>the note has no text</source>
        <translation>poznámka nemá text</translation>
    </message>
    <message>
        <source>the number of angles in a plane</source>
        <translation>počet úhlů v rovině</translation>
    </message>
    <message>
        <source>the number of horizontal angles</source>
        <translation>počet vodorovných úhlů</translation>
    </message>
    <message>
        <source>the number of light sources</source>
        <translation>počet zdrojů</translation>
    </message>
    <message>
        <source>the number of planes</source>
        <translation>počet rovin</translation>
    </message>
    <message>
        <source>the number of sets of light sources</source>
        <translation>počet sad zdrojů</translation>
    </message>
    <message>
        <source>the number of symmetry</source>
        <translation>číslo souměrnosti</translation>
    </message>
    <message>
        <source>the number of tilts</source>
        <translation>počet sklonů</translation>
    </message>
    <message>
        <source>the number of vertical angles</source>
        <translation>počet svislých úhlů</translation>
    </message>
    <message>
        <source>the outer angle is not wider than the inner</source>
        <translation>vnější úhel není větší než vnitřní</translation>
    </message>
    <message>
        <source>the outline was given up</source>
        <translation>hledání obrysu bylo zrušeno</translation>
    </message>
    <message>
        <source>the pack was stopped</source>
        <translation>balení bylo zastaveno</translation>
    </message>
    <message>
        <source>the part of a measure is a number from 1</source>
        <translation>část míry je číslo od 1</translation>
    </message>
    <message>
        <source>the path {0} is not absolute</source>
        <translation>cesta {0} není absolutní</translation>
    </message>
    <message>
        <source>the photometric type</source>
        <translation>fotometrický typ</translation>
    </message>
    <message>
        <source>the plan was given up</source>
        <translation>kreslení plánu bylo zrušeno</translation>
    </message>
    <message>
        <source>the point of the note has a coordinate beyond 1e12; give one near the model</source>
        <translation>bod poznámky má souřadnici za 1e12; zadejte bod u modelu</translation>
    </message>
    <message>
        <source>the point of the section has a coordinate beyond 1e12; give one near the model</source>
        <translation>bod řezu má souřadnici větší než 1e12; uveďte bod poblíž modelu</translation>
    </message>
    <message>
        <source>the position of the light source</source>
        <translation>poloha zdroje</translation>
    </message>
    <message>
        <source>the process that started this server is gone, and no client is connected: it ends</source>
        <translation>proces, který tento server spustil, skončil a žádný klient není připojen: server končí</translation>
    </message>
    <message>
        <source>the recording {0} ended after {1} frames: {2}</source>
        <translation>záznam {0} skončil (počet snímků: {1}): {2}</translation>
    </message>
    <message>
        <source>the scene has no bookmark {0}</source>
        <translation>scéna nemá záložku {0}</translation>
    </message>
    <message>
        <source>the scene has no bookmarks; 'bookmark add' keeps the view as one</source>
        <translation>scéna nemá záložky; pohled jako záložku uchová 'bookmark add'</translation>
    </message>
    <message>
        <source>the scene has no flight {0}; 'flight list' lists them</source>
        <translation>scéna nemá let {0}; vypíše je 'flight list'</translation>
    </message>
    <message>
        <source>the scene has no variant {0}; 'variant list' lists them</source>
        <translation>scéna nemá variantu {0}; vypíše je 'variant list'</translation>
    </message>
    <message>
        <source>the scene names files outside of its folder: {0}; 'pack FOLDER outside' takes them along</source>
        <translation>scéna odkazuje na soubory mimo svou složku: {0}; 'pack FOLDER outside' je přibalí</translation>
    </message>
    <message>
        <source>the scene says so</source>
        <translation>říká to scéna</translation>
    </message>
    <message>
        <source>the second factor of the ballast</source>
        <translation>činitel předřadníku a zdroje</translation>
    </message>
    <message>
        <source>the sections are damaged (their checksum differs)</source>
        <translation>oddíly jsou poškozené (nesouhlasí kontrolní součet)</translation>
    </message>
    <message>
        <source>the server did not answer in time</source>
        <translation>server včas neodpověděl</translation>
    </message>
    <message>
        <source>the server is paused; resume it first</source>
        <translation>server je pozastavený; nejdřív ho nechte pokračovat</translation>
    </message>
    <message>
        <source>the server never idles; 'idle on' lets it</source>
        <translation>server nikdy není v klidu; dovolí mu to 'idle on'</translation>
    </message>
    <message>
        <source>the server was paused</source>
        <translation>server byl pozastaven</translation>
    </message>
    <message>
        <source>the server was paused in the midst of a frame; resume it first</source>
        <translation>server byl pozastaven uprostřed snímku; nejdřív ho nechte pokračovat</translation>
    </message>
    <message>
        <source>the sheen of cloth</source>
        <translation>lesk látky</translation>
    </message>
    <message>
        <source>the sky is turned by 'sky north'</source>
        <translation>oblohu otáčí 'sky north'</translation>
    </message>
    <message>
        <source>the sky that was modelled around it, {0}, is hidden, since it would keep the light out; 'part show' or --show shows it</source>
        <translation>obloha vymodelovaná kolem něj, {0}, je skryta, protože by nepropouštěla světlo; ukáže ji 'part show' nebo --show</translation>
    </message>
    <message>
        <source>the sky that was modelled around it, {0}, lights it as an environment map; 'look sky' shows it under another sky</source>
        <translation>obloha vymodelovaná kolem něj, {0}, ho osvětluje jako mapa prostředí; 'look sky' ho ukáže pod jinou oblohou</translation>
    </message>
    <message>
        <source>the state takes more bytes than an answer has</source>
        <translation>stav je delší, než smí být odpověď</translation>
    </message>
    <message>
        <source>the table of sections is cut off</source>
        <translation>tabulka oddílů je neúplná</translation>
    </message>
    <message>
        <source>the target has a coordinate beyond 1e12; give one near the model</source>
        <translation>cíl má souřadnici za 1e12; zadejte bod poblíž modelu</translation>
    </message>
    <message>
        <source>the text of a note has at most {0} characters and {1} bytes</source>
        <translation>text poznámky má nejvýše {0} znaků a {1} bajtů</translation>
    </message>
    <message>
        <source>the text of a note is UTF-8 without control characters, but for line breaks and tabs</source>
        <translation>text poznámky je UTF-8 bez řídicích znaků kromě konců řádků a tabulátorů</translation>
    </message>
    <message>
        <source>the text of a note is a text</source>
        <translation>text poznámky je text</translation>
    </message>
    <message>
        <source>the textures of material {0} lie on it in different ways; all are laid as the first one is</source>
        <translation>textury materiálu {0} na něm leží různě; všechny jsou položené jako první</translation>
    </message>
    <message>
        <source>the tilt of the luminaire</source>
        <translation>sklon svítidla</translation>
    </message>
    <message>
        <source>the time of the first key frame is 0</source>
        <translation>čas prvního klíčového snímku je 0</translation>
    </message>
    <message>
        <source>the times of key frames rise, up to {0} seconds at most; that of number {1} does not</source>
        <translation>časy klíčových snímků rostou, nejvýše do {0} sekund; čas čísla {1} ne</translation>
    </message>
    <message>
        <source>the two corners of a box differ in each coordinate</source>
        <translation>dva rohy kvádru se musí lišit v každé souřadnici</translation>
    </message>
    <message>
        <source>the unit of lengths</source>
        <translation>jednotka délek</translation>
    </message>
    <message>
        <source>the unit of {0} is not known, so a drawing would have no scale; say it: --units or the command 'units' with m, cm, mm, in or ft (a guess is {1} m)</source>
        <translation>jednotka {0} není známa, takže by výkres neměl měřítko; určete ji: --units nebo příkaz 'units' s m, cm, mm, in nebo ft (odhad je {1} m)</translation>
    </message>
    <message>
        <source>the variant is too long for an answer; 'export scene' writes it</source>
        <translation>varianta je na odpověď příliš dlouhá; zapíše ji 'export scene'</translation>
    </message>
    <message>
        <source>the version is missing; begin the file with: version = {0}</source>
        <translation>chybí verze; začněte soubor řádkem: version = {0}</translation>
    </message>
    <message>
        <source>the watts</source>
        <translation>příkon</translation>
    </message>
    <message>
        <source>the way needs more than {0} key frames; allow it to be farther off</source>
        <translation>cesta potřebuje více než {0} klíčových snímků; dovolte větší odchylku</translation>
    </message>
    <message>
        <source>the weights of {0} have the SHA-256 {1} here, not {2}; use the version of this suite that knows those</source>
        <translation>váhy sítě {0} tu mají SHA-256 {1}, ne {2}; použijte verzi této sady, která je zná</translation>
    </message>
    <message>
        <source>the width of an orthographic view is more than 0</source>
        <translation>šířka ortografického pohledu je víc než 0</translation>
    </message>
    <message>
        <source>there are more chunks than frames; this one is empty</source>
        <translation>dílů je víc než snímků; tento je prázdný</translation>
    </message>
    <message>
        <source>there are more than {0} flights; leave some out</source>
        <translation>letů je více než {0}; některé vynechte</translation>
    </message>
    <message>
        <source>there are more than {0} measures; leave some out</source>
        <translation>je tu více než {0} měr; některé vynechte</translation>
    </message>
    <message>
        <source>there are more than {0} notes; leave some out</source>
        <translation>je tu více než {0} poznámek; některé vynechte</translation>
    </message>
    <message>
        <source>there are more than {0} sections; leave some out</source>
        <translation>řezů je více než {0}; některé vynechte</translation>
    </message>
    <message>
        <source>there are more than {0} variants; leave some out</source>
        <translation>variant je víc než {0}; některé vynechte</translation>
    </message>
    <message>
        <source>there are more warnings than these</source>
        <translation>upozornění je víc než tato</translation>
    </message>
    <message>
        <source>there are six sections already; remove one first</source>
        <translation>řezů je už šest; nejprve jeden odstraňte</translation>
    </message>
    <message>
        <source>there are too many arguments</source>
        <translation>argumentů je příliš mnoho</translation>
    </message>
    <message>
        <source>there are too many records or cells</source>
        <translation>záznamů nebo buněk je příliš mnoho</translation>
    </message>
    <message>
        <source>there are {0} flights already; remove one first</source>
        <translation>letů už je {0}; nejprve některý odstraňte</translation>
    </message>
    <message>
        <source>there are {0} lights, the most that pages may have</source>
        <translation>světel je už {0}, víc jich stránky mít nesmějí</translation>
    </message>
    <message>
        <source>there are {0} measures already; remove one first</source>
        <translation>už je tu {0} měr; nejdřív jednu odeberte</translation>
    </message>
    <message>
        <source>there are {0} notes already; remove one first</source>
        <translation>už je tu {0} poznámek; nejdřív jednu odeberte</translation>
    </message>
    <message>
        <source>there are {0} notes, or were before an edit that can be taken back</source>
        <translation>poznámek je {0}, nebo jich tolik bylo před úpravou, kterou lze vzít zpět</translation>
    </message>
    <message>
        <source>there are {0} notes, the most that visitors may have</source>
        <translation>poznámek je už {0}, víc jich návštěvníci mít nesmějí</translation>
    </message>
    <message>
        <source>there are {0} variants already; remove one first</source>
        <translation>variant je už {0}; nejprve některou odstraňte</translation>
    </message>
    <message>
        <source>there is a file of this name that is no .bsp file; remove it, or name another</source>
        <translation>soubor tohoto jména už existuje a není to .bsp; odstraňte ho, nebo uveďte jiné jméno</translation>
    </message>
    <message>
        <source>there is no 3MF model inside; unpack it and give the model inside</source>
        <translation>uvnitř není žádný model 3MF; rozbalte jej a zadejte model, který je uvnitř</translation>
    </message>
    <message>
        <source>there is no [[variant]] {0} in this file</source>
        <translation>v tomto souboru není [[variant]] {0}</translation>
    </message>
    <message>
        <source>there is no driver now</source>
        <translation>teď nikdo neřídí</translation>
    </message>
    <message>
        <source>there is no edit of yours to make again</source>
        <translation>nemáte žádnou úpravu, kterou by šlo provést znovu</translation>
    </message>
    <message>
        <source>there is no environment {0}</source>
        <translation>mapa okolí {0} tu není</translation>
    </message>
    <message>
        <source>there is no environment {0}; the scene has {1}</source>
        <translation>mapa okolí {0} tu není; scéna má {1}</translation>
    </message>
    <message>
        <source>there is no ffmpeg to make it; install it, or render the frames with -o frame_####.png and make the film of them where it is: {0}</source>
        <translation>chybí ffmpeg, který by ho vytvořil; nainstalujte ho, nebo vykreslete snímky s -o frame_####.png a film z nich vytvořte tam, kde je: {0}</translation>
    </message>
    <message>
        <source>there is no floor below the point</source>
        <translation>pod bodem není podlaha</translation>
    </message>
    <message>
        <source>there is no floor below the viewpoint</source>
        <translation>pod stanovištěm není podlaha</translation>
    </message>
    <message>
        <source>there is no folder {0}; make it first</source>
        <translation>složka {0} neexistuje; nejdřív ji vytvořte</translation>
    </message>
    <message>
        <source>there is no frame for it</source>
        <translation>není pro něj žádný snímek</translation>
    </message>
    <message>
        <source>there is no frame yet, and the server is paused</source>
        <translation>ještě není žádný snímek a server je pozastavený</translation>
    </message>
    <message>
        <source>there is no light {0}</source>
        <translation>světlo {0} tu není</translation>
    </message>
    <message>
        <source>there is no light {0}; the scene has {1}</source>
        <translation>světlo {0} tu není; scéna má {1}</translation>
    </message>
    <message>
        <source>there is no measure {0}; 'measure list' lists them</source>
        <translation>míra {0} není; vypíše je 'measure list'</translation>
    </message>
    <message>
        <source>there is no note {0}; 'note list' lists them</source>
        <translation>poznámka {0} není; vypíše je 'note list'</translation>
    </message>
    <message>
        <source>there is no room to stand here, or no floor below; move elsewhere first</source>
        <translation>není tu místo ke stání, nebo dole není podlaha; nejdřív jděte jinam</translation>
    </message>
    <message>
        <source>there is no section {0}; 'sections' lists them</source>
        <translation>řez {0} neexistuje; vypíše je příkaz sections</translation>
    </message>
    <message>
        <source>there is no server</source>
        <translation>žádný server tu není</translation>
    </message>
    <message>
        <source>there is no state yet</source>
        <translation>stav ještě není známý</translation>
    </message>
    <message>
        <source>there is no storey {0}; {1} were found, of which 1 is the lowest</source>
        <translation>podlaží {0} neexistuje; nalezeno jich bylo {1}, nejnižší má číslo 1</translation>
    </message>
    <message>
        <source>there is no such file; check the path</source>
        <translation>takový soubor tu není; zkontrolujte cestu</translation>
    </message>
    <message>
        <source>there is no such folder to make it in</source>
        <translation>složka, ve které by měl vzniknout, tu není</translation>
    </message>
    <message>
        <source>there is no such key of a material</source>
        <translation>takový klíč materiál nemá</translation>
    </message>
    <message>
        <source>there is no such request</source>
        <translation>takový požadavek není</translation>
    </message>
    <message>
        <source>there is no such setting</source>
        <translation>takové nastavení není</translation>
    </message>
    <message>
        <source>there is no surface there; the light stays as it was</source>
        <translation>není tam žádný povrch; světlo zůstává, jak bylo</translation>
    </message>
    <message>
        <source>there is nothing to focus on; the focus stays as it was</source>
        <translation>není na co zaostřit; zaostření zůstává, jak bylo</translation>
    </message>
    <message>
        <source>there is nothing to measure</source>
        <translation>není tu co měřit</translation>
    </message>
    <message>
        <source>there is nothing to redo</source>
        <translation>není co provést znovu</translation>
    </message>
    <message>
        <source>there is nothing to show</source>
        <translation>není co ukázat</translation>
    </message>
    <message>
        <source>there is nothing to undo</source>
        <translation>není co vrátit</translation>
    </message>
    <message>
        <source>this build cannot read {0}; convert the file to PNG</source>
        <translation>tento program neumí číst {0}; převeďte soubor na PNG</translation>
    </message>
    <message>
        <source>this build cannot write {0}; use .png</source>
        <translation>tento program neumí zapisovat {0}; použijte .png</translation>
    </message>
    <message>
        <source>this build reads no EXR; convert it to .hdr</source>
        <translation>tento program neumí číst EXR; převeďte ho na .hdr</translation>
    </message>
    <message>
        <source>this build writes no EXR</source>
        <translation>tento program neumí zapsat EXR</translation>
    </message>
    <message>
        <source>this build writes no EXR; use .hdr or .pfm</source>
        <translation>tento program neumí zapsat EXR; použijte .hdr nebo .pfm</translation>
    </message>
    <message>
        <source>this byte is no text; save the file as UTF-8</source>
        <translation>tento bajt není text; uložte soubor v UTF-8</translation>
    </message>
    <message>
        <source>this byte is no text; save the list as UTF-8</source>
        <translation>tento bajt není text; uložte seznam v UTF-8</translation>
    </message>
    <message>
        <source>this is a .bsp file already; build from the model that it was made of</source>
        <translation>toto už je soubor .bsp; použijte model, ze kterého vznikl</translation>
    </message>
    <message>
        <source>this is a folder; name a file in it</source>
        <translation>toto je složka; uveďte soubor v ní</translation>
    </message>
    <message>
        <source>this is a preview of an image that is being rendered; it takes no commands</source>
        <translation>toto je náhled obrazu, který se vykresluje; nepřijímá příkazy</translation>
    </message>
    <message>
        <source>this is another net: its SHA-256 is {0}, not {1}; {2} brings the right one</source>
        <translation>to je jiná síť: její SHA-256 je {0}, ne {1}; správnou přinese {2}</translation>
    </message>
    <message>
        <source>this is another net: {0} bytes, not {1}; {2} brings the right one</source>
        <translation>to je jiná síť: {0} bajtů, ne {1}; správnou přinese {2}</translation>
    </message>
    <message>
        <source>this is no date and no time; a text stands in quotes, a number is like 7, -0.5 or 1e6</source>
        <translation>toto není datum ani čas; text patří do uvozovek, číslo vypadá jako 7, -0.5 nebo 1e6</translation>
    </message>
    <message>
        <source>this is no number; write it like 7, -0.5 or 1e6, and a text in quotes</source>
        <translation>toto není číslo; pište čísla jako 7, -0.5 nebo 1e6 a texty do uvozovek</translation>
    </message>
    <message>
        <source>this is no value; a text stands in quotes, a switch is true or false</source>
        <translation>toto není hodnota; text patří do uvozovek, přepínač je true nebo false</translation>
    </message>
    <message>
        <source>this is not a tensor archive (.tza)</source>
        <translation>to není archiv tenzorů (.tza)</translation>
    </message>
    <message>
        <source>this link is for looking only</source>
        <translation>tento odkaz je jen pro diváky</translation>
    </message>
    <message>
        <source>this program has read {0} luminaires, the most that it keeps; start it anew</source>
        <translation>tento program načetl {0} svítidel, víc jich neudrží; spusťte jej znovu</translation>
    </message>
    <message>
        <source>three numbers in brackets</source>
        <translation>tři čísla v hranatých závorkách</translation>
    </message>
    <message>
        <source>tinted-glass</source>
        <translation>tónované sklo</translation>
    </message>
    <message>
        <source>too many brackets within brackets</source>
        <translation>příliš mnoho závorek v závorkách</translation>
    </message>
    <message>
        <source>too many commands before it wait for files that do not answer</source>
        <translation>příliš mnoho předchozích příkazů čeká na soubory, které neodpovídají</translation>
    </message>
    <message>
        <source>too many keys with dots</source>
        <translation>příliš mnoho klíčů s tečkami</translation>
    </message>
    <message>
        <source>too many notes; wait a minute</source>
        <translation>příliš mnoho poznámek; počkejte minutu</translation>
    </message>
    <message>
        <source>too many of its records are in one place</source>
        <translation>příliš mnoho jeho záznamů je na jednom místě</translation>
    </message>
    <message>
        <source>too many requests at once</source>
        <translation>příliš mnoho požadavků najednou</translation>
    </message>
    <message>
        <source>too many values</source>
        <translation>příliš mnoho hodnot</translation>
    </message>
    <message>
        <source>triangle {0} is in no leaf</source>
        <translation>trojúhelník {0} není v žádném listu</translation>
    </message>
    <message>
        <source>triangles: one names a vertex that does not exist</source>
        <translation>triangles: některý uvádí vrchol, který neexistuje</translation>
    </message>
    <message>
        <source>true and false in brackets</source>
        <translation>true a false v hranatých závorkách</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true nebo false</translation>
    </message>
    <message>
        <source>two lights have the id {0}</source>
        <translation>dvě světla mají id {0}</translation>
    </message>
    <message>
        <source>two sections have the same name</source>
        <translation>dva oddíly mají stejné jméno</translation>
    </message>
    <message>
        <source>two tensors have the same name</source>
        <translation>dva tenzory mají stejné jméno</translation>
    </message>
    <message>
        <source>undone, since a frame took more than 5 s</source>
        <translation>vráceno, protože snímek trval déle než 5 s</translation>
    </message>
    <message>
        <source>unexpected row size</source>
        <translation>neočekávaná délka řádku</translation>
    </message>
    <message>
        <source>unknown error</source>
        <translation>neznámá chyba</translation>
    </message>
    <message>
        <source>unknown image format; known are {0}</source>
        <translation>neznámý formát obrazu; známé jsou {0}</translation>
    </message>
    <message>
        <source>unknown key {0}; there are letters, digits, Space, Left, Right, Up, Down, Shift, Control, CapsLock and others</source>
        <translation>neznámá klávesa {0}; jsou tu písmena, číslice, Space, Left, Right, Up, Down, Shift, Control, CapsLock a další</translation>
    </message>
    <message>
        <source>unknown {0} {1}; did you mean {2}?</source>
        <translation>neznámé jméno ({0}): {1}; neměli jste na mysli {2}?</translation>
    </message>
    <message>
        <source>unknown {0} {1}; known: {2}</source>
        <translation>neznámé jméno ({0}): {1}; známá jsou: {2}</translation>
    </message>
    <message>
        <source>unpack it (bunzip2) and give the model inside</source>
        <translation>rozbalte ho (bunzip2) a zadejte model, který je v něm</translation>
    </message>
    <message>
        <source>unpack it (gunzip) and give the model inside</source>
        <translation>rozbalte ho (gunzip) a zadejte model, který je v něm</translation>
    </message>
    <message>
        <source>unpack it (unxz) and give the model inside</source>
        <translation>rozbalte ho (unxz) a zadejte model, který je v něm</translation>
    </message>
    <message>
        <source>unpack it (unzstd) and give the model inside</source>
        <translation>rozbalte ho (unzstd) a zadejte model, který je v něm</translation>
    </message>
    <message>
        <source>unpack it and give the model inside</source>
        <translation>rozbalte ho a zadejte model, který je v něm</translation>
    </message>
    <message>
        <source>up is parallel to the view direction; give another up</source>
        <translation>up je rovnoběžný se směrem pohledu; zadejte jiný</translation>
    </message>
    <message>
        <source>up is zero; give the direction that is up in the image</source>
        <translation>up je nulový; zadejte směr, který je na obrazu nahoru</translation>
    </message>
    <message>
        <source>usual for {0}</source>
        <translation>obvyklé pro {0}</translation>
    </message>
    <message>
        <source>version {0} is unknown; this program reads version 1 to {1}</source>
        <translation>verze {0} je neznámá; tento program čte verze 1 až {1}</translation>
    </message>
    <message>
        <source>version {0} is unknown; this program reads version {1}</source>
        <translation>verze {0} je neznámá; tento program čte verzi {1}</translation>
    </message>
    <message>
        <source>visitor is for 'note add' and 'note at'</source>
        <translation>visitor je pro 'note add' a 'note at'</translation>
    </message>
    <message>
        <source>walking</source>
        <translation>chůze</translation>
    </message>
    <message>
        <source>walnut</source>
        <translation>ořech</translation>
    </message>
    <message>
        <source>warning: {0}</source>
        <translation>varování: {0}</translation>
    </message>
    <message>
        <source>water</source>
        <translation>voda</translation>
    </message>
    <message>
        <source>weights of {0} bytes; at most {1} are read</source>
        <translation>váhy o {0} bajtech; čte se nejvýše {1}</translation>
    </message>
    <message>
        <source>what files show that it names (Inline) is left out, as they are missing or outside of the model's folder: {0}</source>
        <translation>co ukazují soubory, které jmenuje (Inline), je vynecháno, protože chybějí nebo leží mimo složku modelu: {0}</translation>
    </message>
    <message>
        <source>what modifiers make of its meshes, and some objects of its hierarchy, may be missing; export it from Blender as glTF to be sure</source>
        <translation>může chybět, co z jeho sítí dělají modifikátory, a některé objekty jeho hierarchie; pro jistotu jej z Blenderu exportujte jako glTF</translation>
    </message>
    <message>
        <source>what stands in braces reads { key = value, key = value }, all on one line</source>
        <translation>obsah složených závorek má tvar { klíč = hodnota, klíč = hodnota }, celý na jednom řádku</translation>
    </message>
    <message>
        <source>what these X3D nodes show is left out, as they are not read: {0}</source>
        <translation>co zobrazují tyto uzly X3D, je vynecháno, protože se nečtou: {0}</translation>
    </message>
    <message>
        <source>white-paint</source>
        <translation>bílý nátěr</translation>
    </message>
    <message>
        <source>whole numbers in brackets</source>
        <translation>celá čísla v hranatých závorkách</translation>
    </message>
    <message>
        <source>with all instances it has {0} parts and {1} triangles, which take {2} MB of memory, more than the {3} MB that the importer may use; raise that (--memory-limit), else export fewer instances or simplify the model</source>
        <translation>se všemi instancemi má {0} částí a {1} trojúhelníků, které zaberou {2} MB paměti, víc než {3} MB, které importér smí použít; zvyšte je (--memory-limit), nebo exportujte méně instancí či model zjednodušte</translation>
    </message>
    <message>
        <source>with all instances it has {0} parts, more than {1}; export fewer instances</source>
        <translation>se všemi instancemi má {0} částí, více než {1}; exportujte méně instancí</translation>
    </message>
    <message>
        <source>with the [sky]</source>
        <translation>map okolí i s [sky]</translation>
    </message>
    <message>
        <source>written is no time such as 2026-11-30T18:40:00Z</source>
        <translation>written není čas jako 2026-11-30T18:40:00Z</translation>
    </message>
    <message>
        <source>you drive now</source>
        <translation>teď řídíte vy</translation>
    </message>
    <message>
        <source>{0} (and {1} other failures before)</source>
        <translation>{0} (a předtím další selhání: {1})</translation>
    </message>
    <message>
        <source>{0} above {1} and below {2}</source>
        <translation>{0} větší než {1} a menší než {2}</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} a {1}</translation>
    </message>
    <message>
        <source>{0} and {1} are both given</source>
        <translation>{0} a {1} jsou zadány současně</translation>
    </message>
    <message>
        <source>{0} and {1} are both given; leave one out</source>
        <translation>{0} a {1} jsou zadány současně; jedno vynechte</translation>
    </message>
    <message>
        <source>{0} asks to drive</source>
        <translation>{0} žádá o řízení</translation>
    </message>
    <message>
        <source>{0} came with version {1} of this format; begin the file with: version = {1}</source>
        <translation>{0} je až ve verzi {1} tohoto formátu; začněte soubor řádkem: version = {1}</translation>
    </message>
    <message>
        <source>{0} ended without making the film</source>
        <translation>{0} skončil, aniž vytvořil film</translation>
    </message>
    <message>
        <source>{0} failed with exit code {1}</source>
        <translation>{0} selhal s návratovým kódem {1}</translation>
    </message>
    <message>
        <source>{0} files</source>
        <translation>soubory {0}</translation>
    </message>
    <message>
        <source>{0} from {1} to {2}</source>
        <translation>{0} od {1} do {2}</translation>
    </message>
    <message>
        <source>{0} has {1} points, not {2}</source>
        <translation>{0} má bodů {1}, ne {2}</translation>
    </message>
    <message>
        <source>{0} has {1} to {2} points, not {3}</source>
        <translation>{0} má {1} až {2} bodů, ne {3}</translation>
    </message>
    <message>
        <source>{0} has {1} values, but takes three numbers in brackets</source>
        <translation>{0} má hodnot {1}, ale bere tři čísla v hranatých závorkách</translation>
    </message>
    <message>
        <source>{0} has {1}, but takes {2}</source>
        <translation>{0} obsahuje {1}, ale bere {2}</translation>
    </message>
    <message>
        <source>{0} is a number</source>
        <translation>{0} je číslo</translation>
    </message>
    <message>
        <source>{0} is a whole number, at least {1}</source>
        <translation>{0} je celé číslo, nejméně {1}</translation>
    </message>
    <message>
        <source>{0} is for edits; {1} is none</source>
        <translation>{0} je pro úpravy; {1} úprava není</translation>
    </message>
    <message>
        <source>{0} is locked</source>
        <translation>{0} je zamčeno</translation>
    </message>
    <message>
        <source>{0} is no path; give the name of a file</source>
        <translation>{0} není cesta; zadejte jméno souboru</translation>
    </message>
    <message>
        <source>{0} is not bound</source>
        <translation>{0} nic nedělá</translation>
    </message>
    <message>
        <source>{0} is not in {1}..{2}</source>
        <translation>{0} není v rozsahu {1}..{2}</translation>
    </message>
    <message>
        <source>{0} is of another scene or light; it is made anew</source>
        <translation>{0} patří k jiné scéně nebo osvětlení; vytváří se znovu</translation>
    </message>
    <message>
        <source>{0} is open: it has no volume</source>
        <translation>{0} není uzavřená: nemá objem</translation>
    </message>
    <message>
        <source>{0} is out of range</source>
        <translation>{0} je mimo rozsah</translation>
    </message>
    <message>
        <source>{0} is rendered again: {1}</source>
        <translation>{0} se vykreslí znovu: {1}</translation>
    </message>
    <message>
        <source>{0} is taken for up ({1}); 'up {2}' turns the model</source>
        <translation>nahoru je asi {0} ({1}); model otočí 'up {2}'</translation>
    </message>
    <message>
        <source>{0} is the beginning of several commands: {1}</source>
        <translation>{0} je začátek několika příkazů: {1}</translation>
    </message>
    <message>
        <source>{0} is the former name of {1}, which stands here, too; remove {0}</source>
        <translation>{0} je dřívější jméno pro {1}, které tu je také; odstraňte {0}</translation>
    </message>
    <message>
        <source>{0} is up ({1}); one unit is {2} m ({3})</source>
        <translation>vzhůru míří {0} ({1}); jedna jednotka je {2} m ({3})</translation>
    </message>
    <message>
        <source>{0} is what CUI does itself, not the server</source>
        <translation>{0} dělá samo CUI, ne server</translation>
    </message>
    <message>
        <source>{0} is {1} at least here</source>
        <translation>{0} je zde nejméně {1}</translation>
    </message>
    <message>
        <source>{0} is {1} at most here</source>
        <translation>{0} je zde nejvýše {1}</translation>
    </message>
    <message>
        <source>{0} is {1}, but is a whole number from {2} to {3}</source>
        <translation>{0} je {1}, má to ale být celé číslo od {2} do {3}</translation>
    </message>
    <message>
        <source>{0} is {1}, but is from {2} to {3}</source>
        <translation>{0} je {1}, má to ale být od {2} do {3}</translation>
    </message>
    <message>
        <source>{0} is {1}, but takes a whole number, {2}</source>
        <translation>{0} je {1}, ale má to být celé číslo, {2}</translation>
    </message>
    <message>
        <source>{0} is {1}, but takes one value</source>
        <translation>{0} je {1}, ale má to být jedna hodnota</translation>
    </message>
    <message>
        <source>{0} is {1}, but takes {2}</source>
        <translation>{0} je {1}, ale má to být {2}</translation>
    </message>
    <message>
        <source>{0} is {1}, which is for stills, not for the live view; put it into [still], or use 'Renderer --setting {0}={1}'</source>
        <translation>{0} je {1}, což je pro výsledné obrazy, ne pro živý pohled; dejte to do [still], nebo použijte 'Renderer --setting {0}={1}'</translation>
    </message>
    <message>
        <source>{0} lines and points are left out; only surfaces are shown</source>
        <translation>vynechané čáry a body: {0}; ukazují se jen plochy</translation>
    </message>
    <message>
        <source>{0} lists of normals, colours, texture coordinates or joints are damaged and left out</source>
        <translation>seznamů normál, barev, souřadnic textur nebo kloubů poškozených a vynechaných: {0}</translation>
    </message>
    <message>
        <source>{0} m are taken for a unit ({1}); 'units' sets another</source>
        <translation>jednotka je asi {0} m ({1}); jinou nastaví 'units'</translation>
    </message>
    <message>
        <source>{0} material is guessed by name ({1})</source>
        <translation>materiály odhadnuté podle jména: {0} ({1})</translation>
    </message>
    <message>
        <source>{0} materials are guessed by name ({1})</source>
        <translation>materiály odhadnuté podle jména: {0} ({1})</translation>
    </message>
    <message>
        <source>{0} meshes of nodes that show the geometry of another have its materials: their own are not read, as no node uses them first</source>
        <translation>sítě uzlů, které zobrazují geometrii jiného uzlu ({0}), mají jeho materiály: jejich vlastní se nečtou, protože je žádný uzel nepoužívá jako první</translation>
    </message>
    <message>
        <source>{0} of its components are left out: they name objects that do not exist</source>
        <translation>vynechané komponenty: {0}; uvádějí objekty, které neexistují</translation>
    </message>
    <message>
        <source>{0} of its meshes are left out: their data are damaged or missing</source>
        <translation>vynechaných sítí: {0}; jejich data jsou poškozená nebo chybí</translation>
    </message>
    <message>
        <source>{0} of {1} frames are there already (--force renders them again)</source>
        <translation>hotové snímky: {0} z {1} (--force je vykreslí znovu)</translation>
    </message>
    <message>
        <source>{0} of {1} frames failed</source>
        <translation>nezdařené snímky: {0} z {1}</translation>
    </message>
    <message>
        <source>{0} of {1} points are left out: their coordinates are no numbers or beyond 1e12</source>
        <translation>vynechané body: {0} z {1}; jejich souřadnice nejsou čísla nebo přesahují 1e12</translation>
    </message>
    <message>
        <source>{0} of {1} points are left out: they lie where others do</source>
        <translation>vynechané body: {0} z {1}; leží tam, kde jiné</translation>
    </message>
    <message>
        <source>{0} of {1} triangle was damaged and left out: {2}</source>
        <translation>vynechané poškozené trojúhelníky: {0} z {1}: {2}</translation>
    </message>
    <message>
        <source>{0} of {1} triangles was damaged and left out: {2}</source>
        <translation>vynechané poškozené trojúhelníky: {0} z {1}: {2}</translation>
    </message>
    <message>
        <source>{0} of {1} triangles were damaged and left out: {2}</source>
        <translation>vynechané poškozené trojúhelníky: {0} z {1}: {2}</translation>
    </message>
    <message>
        <source>{0} old versions of it are kept, {1}~ and so on; remove those that you do not need</source>
        <translation>už je tu {0} jeho starých verzí, {1}~ a další; odstraňte ty, které nepotřebujete</translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation>{0} nebo {1}</translation>
    </message>
    <message>
        <source>{0} parts that a section cuts are not closed, so that they have no caps and one looks into them; the first is {1}</source>
        <translation>částí ({0}), které řez protíná, není uzavřených, takže nemají plochu řezu a je do nich vidět; první je {1}</translation>
    </message>
    <message>
        <source>{0} samples are brighter than {1} and count as that: the image has less light than the scene</source>
        <translation>některé vzorky ({0}) jsou jasnější než {1} a počítají se jako to: v obrazu je méně světla než ve scéně</translation>
    </message>
    <message>
        <source>{0} samples were not finite and do not count; the scene has numbers that are too large</source>
        <translation>některé vzorky ({0}) nejsou konečné a nepočítají se; scéna obsahuje příliš velká čísla</translation>
    </message>
    <message>
        <source>{0} sheets: {1} to {2}</source>
        <translation>{0} listů: {1} až {2}</translation>
    </message>
    <message>
        <source>{0} should stand here, a number, and not '{1}'</source>
        <translation>zde má stát {0}, číslo, a ne „{1}“</translation>
    </message>
    <message>
        <source>{0} takes a number, from 1</source>
        <translation>{0} bere číslo, od 1</translation>
    </message>
    <message>
        <source>{0} takes no arguments</source>
        <translation>{0} nebere žádné argumenty</translation>
    </message>
    <message>
        <source>{0} takes no number</source>
        <translation>{0} nebere číslo</translation>
    </message>
    <message>
        <source>{0} takes no numbers</source>
        <translation>{0} nebere čísla</translation>
    </message>
    <message>
        <source>{0} takes nothing, or RIGHT and DOWN</source>
        <translation>{0} nebere nic, nebo RIGHT a DOWN</translation>
    </message>
    <message>
        <source>{0} takes three numbers</source>
        <translation>{0} bere tři čísla</translation>
    </message>
    <message>
        <source>{0} takes {1}</source>
        <translation>{0} bere {1}</translation>
    </message>
    <message>
        <source>{0} takes {1} for {3}, not {2}</source>
        <translation>{0} bere jako {3} {1}, ne {2}</translation>
    </message>
    <message>
        <source>{0} takes {1}, not {2}</source>
        <translation>{0} bere {1}, ne {2}</translation>
    </message>
    <message>
        <source>{0} textures are missing, so their materials are plain: {1}</source>
        <translation>chybějící textury: {0}, jejich materiály jsou jednobarevné: {1}</translation>
    </message>
    <message>
        <source>{0} times {1} angles are too many; at most {2} intensities are taken</source>
        <translation>{0} krát {1} úhlů je příliš mnoho; svítivostí smí být nejvýš {2}</translation>
    </message>
    <message>
        <source>{0} to {1}</source>
        <translation>{0} až {1}</translation>
    </message>
    <message>
        <source>{0} triangle is the third or a further one of the same corners and left out</source>
        <translation>vynechané trojúhelníky, které jsou třetí nebo další se stejnými vrcholy: {0}</translation>
    </message>
    <message>
        <source>{0} triangles are the third or a further one of the same corners and left out</source>
        <translation>vynechané trojúhelníky, které jsou třetí nebo další se stejnými vrcholy: {0}</translation>
    </message>
    <message>
        <source>{0} triangles name colours or materials that do not exist, and are plain grey</source>
        <translation>trojúhelníky s barvami nebo materiály, které neexistují: {0}; jsou prostě šedé</translation>
    </message>
    <message>
        <source>{0} was ended by a signal ({1})</source>
        <translation>{0} byl ukončen signálem ({1})</translation>
    </message>
    <message>
        <source>{0} with coordinates that are no numbers or beyond 1e12</source>
        <translation>{0} se souřadnicemi, které nejsou čísla nebo přesahují 1e12</translation>
    </message>
    <message>
        <source>{0} with corners that do not exist</source>
        <translation>{0} s vrcholy, které neexistují</translation>
    </message>
    <message>
        <source>{0} without area</source>
        <translation>{0} bez plochy</translation>
    </message>
    <message>
        <source>{0} x {1} are more than {2} pixels</source>
        <translation>{0} x {1} je víc než {2} pixelů</translation>
    </message>
    <message>
        <source>{0} x {1} pixels are more than an image can have; take fewer to an inch or a smaller scale; lines without light go on several sheets of paper</source>
        <translation>{0} x {1} pixelů je více, než obrázek může mít; zvolte méně na palec nebo menší měřítko; čáry bez světla se vejdou na několik listů papíru</translation>
    </message>
    <message>
        <source>{0} {1}; these stay as they are</source>
        <translation>{0} {1}; ta zůstávají, jak jsou</translation>
    </message>
    <message>
        <source>{0}' and '{1}</source>
        <translation>{0}' a '{1}</translation>
    </message>
    <message>
        <source>{0}' and {1} more</source>
        <translation>{0}' a další ({1})</translation>
    </message>
    <message>
        <source>{0}, at least {1}</source>
        <translation>{0}, nejméně {1}</translation>
    </message>
    <message>
        <source>{0}, line {1}: {2} is not understood and passed over</source>
        <translation>{0}, řádek {1}: {2} není srozumitelné a přeskakuje se</translation>
    </message>
    <message>
        <source>{0}, line {1}: {2} is not understood and passed over, as are {3} lines more</source>
        <translation>{0}, řádek {1}: {2} není srozumitelné a přeskakuje se, a s ním další řádky: {3}</translation>
    </message>
    <message>
        <source>{0}, line {1}: {2} is not understood and passed over, as is {3} line more</source>
        <translation>{0}, řádek {1}: {2} není srozumitelné a přeskakuje se, a s ním ještě {3} řádek</translation>
    </message>
    <message>
        <source>{0}, or {1}</source>
        <translation>{0}, nebo {1}</translation>
    </message>
    <message>
        <source>{0}: a number of element {1} is not a number or out of range</source>
        <translation>{0}: některé číslo prvku {1} není číslo nebo je mimo rozsah</translation>
    </message>
    <message>
        <source>{0}: drawings are .svg, .pdf, .dxf, .png or .tif files</source>
        <translation>{0}: výkresy jsou soubory .svg, .pdf, .dxf, .png nebo .tif</translation>
    </message>
    <message>
        <source>{0}: element {1}: {2}</source>
        <translation>{0}: prvek {1}: {2}</translation>
    </message>
    <message>
        <source>{0}: is the light of another scene; it is not used</source>
        <translation>{0}: je to světlo jiné scény; nepoužije se</translation>
    </message>
    <message>
        <source>{0}: it is not used: that takes indirect.mode=live, and by paths a net that denoises</source>
        <translation>{0}: nepoužije se: k tomu je třeba indirect.mode=live a u cest síť, která odšumuje</translation>
    </message>
    <message>
        <source>{0}: no memory for it: {1}</source>
        <translation>{0}: není na to paměť: {1}</translation>
    </message>
    <message>
        <source>{0}: part of it is missing or wrong here</source>
        <translation>{0}: část chybí nebo je tu jinak</translation>
    </message>
    <message>
        <source>{0}; 'material reset *' takes them as they are</source>
        <translation>{0}; jak jsou v souboru, je ukáže 'material reset *'</translation>
    </message>
    <message>
        <source>{0}; --up and --units, or 'up' and 'metresPerUnit' in a .scn, say it</source>
        <translation>{0}; určuje to --up a --units, nebo 'up' a 'metresPerUnit' v .scn</translation>
    </message>
    <message>
        <source>{0}; build it again with BSPBuilder</source>
        <translation>{0}; vytvořte ho znovu programem BSPBuilder</translation>
    </message>
    <message>
        <source>{0}; check its permissions</source>
        <translation>{0}; zkontrolujte jeho oprávnění</translation>
    </message>
    <message>
        <source>{0}; check the spelling and the folder</source>
        <translation>{0}; zkontrolujte jméno a složku</translation>
    </message>
    <message>
        <source>{0}; choose a shorter name</source>
        <translation>{0}; zvolte kratší jméno</translation>
    </message>
    <message>
        <source>{0}; choose another folder</source>
        <translation>{0}; zvolte jinou složku</translation>
    </message>
    <message>
        <source>{0}; choose another name, or remove it</source>
        <translation>{0}; zvolte jiné jméno, nebo ho odstraňte</translation>
    </message>
    <message>
        <source>{0}; delete it, and its light is learned anew</source>
        <translation>{0}; smažte ho, světlo se pak zjistí znovu</translation>
    </message>
    <message>
        <source>{0}; free some space there</source>
        <translation>{0}; uvolněte tam místo</translation>
    </message>
    <message>
        <source>{0}; it is damaged: copy or export it again</source>
        <translation>{0}; je poškozený: zkopírujte nebo exportujte ho znovu</translation>
    </message>
    <message>
        <source>{0}; make its folder first</source>
        <translation>{0}; nejdřív vytvořte jeho složku</translation>
    </message>
    <message>
        <source>{0}; name a file in it</source>
        <translation>{0}; zadejte soubor v ní</translation>
    </message>
    <message>
        <source>{0}; no scene needs that</source>
        <translation>{0}; to žádná scéna nepotřebuje</translation>
    </message>
    <message>
        <source>{0}; open it in the program that wrote it and export it again, as glTF or OBJ for example</source>
        <translation>{0}; otevřete ho v programu, který ho zapsal, a exportujte znovu, například jako glTF nebo OBJ</translation>
    </message>
    <message>
        <source>{1} is too large a number</source>
        <translation>číslo {1} je příliš velké</translation>
    </message>
</context>
</TS>
