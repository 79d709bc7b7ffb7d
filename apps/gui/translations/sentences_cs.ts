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
        <source>'{0}' is no day from 1800 to 2200 such as {1}</source>
        <translation>'{0}' není den od roku 1800 do 2200, například {1}</translation>
    </message>
    <message>
        <source>A viewer asks to drive</source>
        <translation>Divák žádá o řízení</translation>
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
        <source>Operation not permitted</source>
        <translation>operace není povolená</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>přístup odepřen</translation>
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
        <source>Too many levels of symbolic links</source>
        <translation>příliš mnoho odkazů za sebou</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>příliš mnoho otevřených souborů</translation>
    </message>
    <message>
        <source>[[environment]]</source>
        <translation>položek [[environment]]</translation>
    </message>
    <message>
        <source>a bookmark needs a name, in UTF-8</source>
        <translation>záložka potřebuje jméno v UTF-8</translation>
    </message>
    <message>
        <source>a date or time</source>
        <translation>datum nebo čas</translation>
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
        <source>a few vertices lie more than 100000 times as far off as all others, which are too small to be seen beside them; remove them or place the camera yourself</source>
        <translation>několik vrcholů leží víc než 100000krát dál než všechny ostatní, které vedle nich nejsou vidět; odstraňte je, nebo umístěte kameru sami</translation>
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
        <source>a key has too many parts</source>
        <translation>klíč má příliš mnoho částí</translation>
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
        <source>a name in quotes</source>
        <translation>jméno v uvozovkách</translation>
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
        <source>a pack is being made already; wait for it, or give it up by 'pack stop'</source>
        <translation>balíček se už vytváří; počkejte na něj, nebo ho zrušte příkazem 'pack stop'</translation>
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
        <source>a quotation mark is not closed</source>
        <translation>uvozovka není uzavřená</translation>
    </message>
    <message>
        <source>a recording is under way: {0}; 'export video stop' ends it</source>
        <translation>už se nahrává: {0}; ukončí to 'export video stop'</translation>
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
        <source>a table</source>
        <translation>tabulka</translation>
    </message>
    <message>
        <source>a table, [{0}]</source>
        <translation>tabulka, [{0}]</translation>
    </message>
    <message>
        <source>a texture is turned on its surface; that is not supported, so it is not turned</source>
        <translation>textura je na povrchu natočená; to se nepodporuje, takže natočená není</translation>
    </message>
    <message>
        <source>a value is a boolean, a number or a text</source>
        <translation>hodnota je true nebo false, číslo, nebo text</translation>
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
        <source>a {0} light has no cone</source>
        <translation>{0} světlo nemá kužel</translation>
    </message>
    <message>
        <source>a {0} light has no surface that mirrors show</source>
        <translation>{0} světlo nemá plochu, kterou by ukazovala zrcadla</translation>
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
        <source>an array</source>
        <translation>pole</translation>
    </message>
    <message>
        <source>an environment has exactly one of the keys equirectangular, cross, strip, faces and parts</source>
        <translation>environment má právě jeden z klíčů equirectangular, cross, strip, faces a parts</translation>
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
        <source>another scene is being loaded</source>
        <translation>načítá se jiná scéna</translation>
    </message>
    <message>
        <source>another scene was shown</source>
        <translation>ukázala se jiná scéna</translation>
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
        <source>bloom off</source>
        <translation>záře vypnuta</translation>
    </message>
    <message>
        <source>bloom on</source>
        <translation>záře zapnuta</translation>
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
        <source>check its permissions, or name another place</source>
        <translation>zkontrolujte její oprávnění, nebo zvolte jiné místo</translation>
    </message>
    <message>
        <source>chrome</source>
        <translation>chrom</translation>
    </message>
    <message>
        <source>command</source>
        <translation>příkaz</translation>
    </message>
    <message>
        <source>damaged PFM: its header has lines for the kind, the size and the byte order</source>
        <translation>poškozený PFM: hlavička má řádky s druhem, velikostí a pořadím bajtů</translation>
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
        <source>damaged TIFF: rows of an odd size</source>
        <translation>poškozený TIFF: řádky zvláštní délky</translation>
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
        <source>faces has {0} files, but takes six: +x, -x, +y, -y, +z, -z</source>
        <translation>faces má {0} souborů, ale bere šest: +x, -x, +y, -y, +z, -z</translation>
    </message>
    <message>
        <source>flying</source>
        <translation>let</translation>
    </message>
    <message>
        <source>forward is zero; the camera needs a direction</source>
        <translation>forward je nulový; kamera potřebuje směr</translation>
    </message>
    <message>
        <source>free some space or set TMPDIR to another folder</source>
        <translation>uvolněte místo, nebo nastavte TMPDIR na jinou složku</translation>
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
        <source>ignored, since not supported: {0}</source>
        <translation>ignorováno, protože se nepodporuje: {0}</translation>
    </message>
    <message>
        <source>innerAngle must be below outerAngle, by enough to tell them apart</source>
        <translation>innerAngle musí být znatelně menší než outerAngle</translation>
    </message>
    <message>
        <source>it has more than 2^30 triangles; split the model</source>
        <translation>má víc než 2^30 trojúhelníků; rozdělte model</translation>
    </message>
    <message>
        <source>it is a pipe without a writer; give a file</source>
        <translation>je to roura, do které nikdo nepíše; zadejte soubor</translation>
    </message>
    <message>
        <source>it is empty; export the model again</source>
        <translation>je prázdný; exportujte model znovu</translation>
    </message>
    <message>
        <source>it is no image any more; choose another environment map</source>
        <translation>už to není obraz; zvolte jinou mapu okolí</translation>
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
        <source>it is there already, and not empty; name another folder</source>
        <translation>už tu je a není prázdná; zvolte jinou složku</translation>
    </message>
    <message>
        <source>it names {0}, which is not there</source>
        <translation>odkazuje na {0}, který tu není</translation>
    </message>
    <message>
        <source>it was written or changed by hand, and its comments and its layout would be lost; add 'replace', then it is kept as {0}</source>
        <translation>byl napsán nebo změněn ručně a ztratil by komentáře i úpravu; přidejte 'replace', pak zůstane jako {0}</translation>
    </message>
    <message>
        <source>its copy does not find {0}; make a .bsp of it by BSPBuilder and pack that</source>
        <translation>jeho kopie nenajde {0}; udělejte z něj programem BSPBuilder .bsp a zabalte ten</translation>
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
        <source>its model is a scene file too; name a .bsp or a model: {0}</source>
        <translation>jeho model je také soubor scény; zadejte .bsp nebo model: {0}</translation>
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
        <source>left out, since nothing of it is used: {0}</source>
        <translation>vynecháno, protože se z toho nic nepoužívá: {0}</translation>
    </message>
    <message>
        <source>libtiff cannot be started</source>
        <translation>libtiff nelze spustit</translation>
    </message>
    <message>
        <source>libtiff cannot write the directory</source>
        <translation>libtiff nemůže zapsat adresář</translation>
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
        <source>linear colour goes into .exr, .hdr or .pfm only</source>
        <translation>lineární barvy lze uložit jen do .exr, .hdr nebo .pfm</translation>
    </message>
    <message>
        <source>lookAt is where eye is; the camera needs a direction</source>
        <translation>lookAt je tam, kde eye; kamera potřebuje směr</translation>
    </message>
    <message>
        <source>lx is for directional lights; others give off lm or W</source>
        <translation>lx je pro směrová světla; ostatní mají lm nebo W</translation>
    </message>
    <message>
        <source>material library {0} are missing; what it describes is plain grey</source>
        <translation>knihovny materiálů {0} chybí; co popisují, je šedé</translation>
    </message>
    <message>
        <source>material library {0} is missing; what it describes is plain grey</source>
        <translation>knihovna materiálů {0} chybí; co popisuje, je šedé</translation>
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
        <source>name is empty; a bookmark is known by its name</source>
        <translation>name je prázdné; záložka se pozná podle jména</translation>
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
        <source>no environment map is shown</source>
        <translation>žádná mapa okolí se neukazuje</translation>
    </message>
    <message>
        <source>no folder can be made here: {0}; {1}</source>
        <translation>nelze tu vytvořit složku: {0}; {1}</translation>
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
        <source>none</source>
        <translation>žádné</translation>
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
        <source>not written, since it could not be read back: {0}</source>
        <translation>nezapsáno, protože by to nešlo znovu přečíst: {0}</translation>
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
        <source>of its {0} MB hardly any were ever written; copy or export it again</source>
        <translation>z jeho {0} MB skoro nic nebylo zapsáno; zkopírujte nebo exportujte ho znovu</translation>
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
        <source>pages give no {0}</source>
        <translation>stránky neposílají {0}</translation>
    </message>
    <message>
        <source>parts names no part; give at least one</source>
        <translation>parts neuvádí žádnou část; zadejte aspoň jednu</translation>
    </message>
    <message>
        <source>paths in brackets</source>
        <translation>cesty v hranatých závorkách</translation>
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
        <source>recording ended: {0}</source>
        <translation>nahrávání skončilo: {0}</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>obdélníkové</translation>
    </message>
    <message>
        <source>right is zero or along direction; give where the width of the light points to</source>
        <translation>right je nulový nebo rovnoběžný s direction; zadejte, kam míří šířka světla</translation>
    </message>
    <message>
        <source>seen takes numbers from 0 to 1, not '{0}'</source>
        <translation>seen bere čísla od 0 do 1, ne '{0}'</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>nastavení</translation>
    </message>
    <message>
        <source>so much light cannot be counted</source>
        <translation>tolik světla nelze vyjádřit</translation>
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
        <source>stopped</source>
        <translation>zastaveno</translation>
    </message>
    <message>
        <source>such files</source>
        <translation>takové soubory</translation>
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
        <source>the camera needs a direction to look in</source>
        <translation>kamera potřebuje směr pohledu</translation>
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
        <source>the driver is asked</source>
        <translation>žádost dostal ten, kdo řídí</translation>
    </message>
    <message>
        <source>the field of view is more than 0 and less than 180 degrees</source>
        <translation>zorný úhel je víc než 0 a méně než 180 stupňů</translation>
    </message>
    <message>
        <source>the file ends too early: it is damaged or was not copied completely</source>
        <translation>soubor končí příliš brzy: je poškozený, nebo nebyl zkopírován celý</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>soubor je prázdný</translation>
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
        <source>the inner angle must be below the outer one, by enough to tell them apart</source>
        <translation>vnitřní úhel musí být znatelně menší než vnější</translation>
    </message>
    <message>
        <source>the key {0} is missing here; add it</source>
        <translation>chybí tu klíč {0}; přidejte ho</translation>
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
        <source>the lights were edited</source>
        <translation>světla byla upravena</translation>
    </message>
    <message>
        <source>the list names no camera</source>
        <translation>seznam neuvádí žádnou kameru</translation>
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
        <source>the name of a light is a text in UTF-8</source>
        <translation>jméno světla je text v UTF-8</translation>
    </message>
    <message>
        <source>the pack was stopped</source>
        <translation>balení bylo zastaveno</translation>
    </message>
    <message>
        <source>the path {0} is not absolute</source>
        <translation>cesta {0} není absolutní</translation>
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
        <source>the scene names files outside of its folder: {0}; 'pack FOLDER outside' takes them along</source>
        <translation>scéna odkazuje na soubory mimo svou složku: {0}; 'pack FOLDER outside' je přibalí</translation>
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
        <source>the sky is turned by 'sky north'</source>
        <translation>oblohu otáčí 'sky north'</translation>
    </message>
    <message>
        <source>the state takes more bytes than an answer has</source>
        <translation>stav je delší, než smí být odpověď</translation>
    </message>
    <message>
        <source>the textures of material {0} lie on it in different ways; all are laid as the first one is</source>
        <translation>textury materiálu {0} na něm leží různě; všechny jsou položené jako první</translation>
    </message>
    <message>
        <source>the version is missing; begin the file with: version = {0}</source>
        <translation>chybí verze; začněte soubor řádkem: version = {0}</translation>
    </message>
    <message>
        <source>the width of an orthographic view is more than 0</source>
        <translation>šířka ortografického pohledu je víc než 0</translation>
    </message>
    <message>
        <source>there are more warnings than these</source>
        <translation>upozornění je víc než tato</translation>
    </message>
    <message>
        <source>there are too many arguments</source>
        <translation>argumentů je příliš mnoho</translation>
    </message>
    <message>
        <source>there are {0} lights, the most that pages may have</source>
        <translation>světel je už {0}, víc jich stránky mít nesmějí</translation>
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
        <source>there is no room to stand here, or no floor below; move elsewhere first</source>
        <translation>není tu místo ke stání, nebo dole není podlaha; nejdřív jděte jinam</translation>
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
        <source>there is no such bookmark</source>
        <translation>taková záložka tu není</translation>
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
        <source>this link is for looking only</source>
        <translation>tento odkaz je jen pro diváky</translation>
    </message>
    <message>
        <source>three numbers in brackets</source>
        <translation>tři čísla v hranatých závorkách</translation>
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
        <source>too many requests at once</source>
        <translation>příliš mnoho požadavků najednou</translation>
    </message>
    <message>
        <source>too many values</source>
        <translation>příliš mnoho hodnot</translation>
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
        <source>undone, since a frame took more than 5 s</source>
        <translation>vráceno, protože snímek trval déle než 5 s</translation>
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
        <source>walking</source>
        <translation>chůze</translation>
    </message>
    <message>
        <source>water</source>
        <translation>voda</translation>
    </message>
    <message>
        <source>whole numbers in brackets</source>
        <translation>celá čísla v hranatých závorkách</translation>
    </message>
    <message>
        <source>with the [sky]</source>
        <translation>map okolí i s [sky]</translation>
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
        <source>{0} files</source>
        <translation>soubory {0}</translation>
    </message>
    <message>
        <source>{0} from {1} to {2}</source>
        <translation>{0} od {1} do {2}</translation>
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
        <source>{0} is out of range</source>
        <translation>{0} je mimo rozsah</translation>
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
        <source>{0}, or {1}</source>
        <translation>{0}, nebo {1}</translation>
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
        <source>{0}; free some space there</source>
        <translation>{0}; uvolněte tam místo</translation>
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
</context>
</TS>
