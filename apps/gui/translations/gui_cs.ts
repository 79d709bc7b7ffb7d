<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="cs" sourcelanguage="en">
<context>
    <name>Bindings</name>
    <message>
        <source>Forward</source>
        <translation>Vpřed</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Vzad</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Vlevo</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Vpravo</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nahoru</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Dolů</translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation>Otočit vlevo</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>Otočit vpravo</translation>
    </message>
    <message>
        <source>Look up</source>
        <translation>Pohled nahoru</translation>
    </message>
    <message>
        <source>Look down</source>
        <translation>Pohled dolů</translation>
    </message>
    <message>
        <source>Jump</source>
        <translation>Skok</translation>
    </message>
    <message>
        <source>Crouch</source>
        <translation>Přikrčit se</translation>
    </message>
    <message>
        <source>Crawl</source>
        <translation>Plazit se</translation>
    </message>
    <message>
        <source>Sprint</source>
        <translation>Běh</translation>
    </message>
    <message>
        <source>Walk or fly</source>
        <translation>Chůze nebo let</translation>
    </message>
    <message>
        <source>Bloom on or off</source>
        <translation>Zapnout nebo vypnout záři</translation>
    </message>
    <message>
        <source>Light on or off</source>
        <translation>Zapnout nebo vypnout světlo</translation>
    </message>
    <message>
        <source>Environment map</source>
        <translation>Mapa prostředí</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>Basilica in the sun</source>
        <translation>Bazilika na slunci</translation>
    </message>
    <message>
        <source>Mirrors and glass</source>
        <translation>Zrcadla a sklo</translation>
    </message>
    <message>
        <source>Elephants at a pond</source>
        <translation>Sloni u rybníka</translation>
    </message>
</context>
<context>
    <name>JobPhase</name>
    <message>
        <source>reading the scene</source>
        <translation>čtení scény</translation>
    </message>
    <message>
        <source>importing</source>
        <translation>import</translation>
    </message>
    <message>
        <source>building the tree</source>
        <translation>stavba stromu</translation>
    </message>
    <message>
        <source>loading images</source>
        <translation>načítání obrázků</translation>
    </message>
    <message>
        <source>rendering</source>
        <translation>vykreslování</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>zápis</translation>
    </message>
    <message>
        <source>denoising</source>
        <translation>odstraňování šumu</translation>
    </message>
    <message>
        <source>checking the tree</source>
        <translation>kontrola stromu</translation>
    </message>
    <message>
        <source>checking</source>
        <translation>kontrola</translation>
    </message>
    <message>
        <source>waiting for frames</source>
        <translation>čekání na snímky</translation>
    </message>
    <message>
        <source>measuring the light</source>
        <translation>měření světla</translation>
    </message>
    <message>
        <source>finishing the film</source>
        <translation>dokončování filmu</translation>
    </message>
</context>
<context>
    <name>Skies</name>
    <message>
        <source>Day</source>
        <translation>Den</translation>
    </message>
    <message>
        <source>Sunset</source>
        <translation>Západ slunce</translation>
    </message>
    <message>
        <source>Night</source>
        <translation>Noc</translation>
    </message>
</context>
<context>
    <name>gui</name>
    <message>
        <source>Click, Enter</source>
        <translation>Kliknutí, Enter</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Myš</translation>
    </message>
    <message>
        <source>Look around</source>
        <translation>Rozhlížení</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Kolečko</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Rychlost</translation>
    </message>
    <message>
        <source>Export the camera</source>
        <translation>Exportovat kameru</translation>
    </message>
    <message>
        <source>Export the camera for high quality</source>
        <translation>Exportovat kameru pro vysokou kvalitu</translation>
    </message>
    <message>
        <source>Render in higher quality</source>
        <translation>Vykreslit ve vyšší kvalitě</translation>
    </message>
    <message>
        <source>The same with anti-aliasing</source>
        <translation>Totéž s vyhlazováním hran</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>Pohyb</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Obraz</translation>
    </message>
    <message>
        <source>Menus</source>
        <translation>Nabídky</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>pozastaven</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>hotovo</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>kreslí</translation>
    </message>
    <message>
        <source> (%1 %)</source>
        <translation> (%1 %)</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>chůze</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>létání</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 sn./s</translation>
    </message>
    <message>
        <source>● recording</source>
        <translation>● záznam</translation>
    </message>
    <message>
        <source>Waiting for the server “%1”…</source>
        <translation>Čeká se na server „%1“…</translation>
    </message>
    <message>
        <source>The server is busy…</source>
        <translation>Server je zaneprázdněn…</translation>
    </message>
    <message>
        <source>The server has ended.</source>
        <translation>Server skončil.</translation>
    </message>
    <message>
        <source>Loading… %1 %</source>
        <translation>Načítání… %1 %</translation>
    </message>
    <message>
        <source>Rendering first frame…</source>
        <translation>Vykresluje se první snímek…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Otevřít…</translation>
    </message>
    <message>
        <source>Show a scene or a model</source>
        <translation>Zobrazit scénu nebo model</translation>
    </message>
    <message>
        <source>&amp;Import camera…</source>
        <translation>&amp;Importovat kameru…</translation>
    </message>
    <message>
        <source>Look through a .cam file</source>
        <translation>Převzít pohled ze souboru .cam</translation>
    </message>
    <message>
        <source>E&amp;xit</source>
        <translation>&amp;Konec</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Zavřít okno</translation>
    </message>
    <message>
        <source>&amp;Connect…</source>
        <translation>&amp;Připojit…</translation>
    </message>
    <message>
        <source>Connect to a running server</source>
        <translation>Připojit se k běžícímu serveru</translation>
    </message>
    <message>
        <source>&amp;Start new server…</source>
        <translation>&amp;Spustit nový server…</translation>
    </message>
    <message>
        <source>Start a server with a scene or a model, and connect to it</source>
        <translation>Spustit server se scénou nebo modelem a připojit se k němu</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Odpojit</translation>
    </message>
    <message>
        <source>Leave the server; it goes on</source>
        <translation>Opustit server; poběží dál</translation>
    </message>
    <message>
        <source>Server &amp;log</source>
        <translation>&amp;Výpis serveru</translation>
    </message>
    <message>
        <source>&amp;Export camera…</source>
        <translation>&amp;Exportovat kameru…</translation>
    </message>
    <message>
        <source>Write the camera to a .cam file</source>
        <translation>Zapsat kameru do souboru .cam</translation>
    </message>
    <message>
        <source>&amp;Recording…</source>
        <translation>&amp;Záznam…</translation>
    </message>
    <message>
        <source>&amp;Quick render</source>
        <translation>&amp;Rychlé vykreslení</translation>
    </message>
    <message>
        <source>Show the current view in higher quality</source>
        <translation>Zobrazit aktuální pohled ve vyšší kvalitě</translation>
    </message>
    <message>
        <source>S&amp;creenshot</source>
        <translation>Uložit &amp;snímek</translation>
    </message>
    <message>
        <source>Save the image under the next free name</source>
        <translation>Uložit obraz pod dalším volným názvem</translation>
    </message>
    <message>
        <source>Cop&amp;y camera</source>
        <translation>&amp;Kopírovat kameru</translation>
    </message>
    <message>
        <source>Copy the camera as text</source>
        <translation>Kopírovat kameru jako text</translation>
    </message>
    <message>
        <source>&amp;Paste camera</source>
        <translation>&amp;Vložit kameru</translation>
    </message>
    <message>
        <source>Look through the camera of the clipboard</source>
        <translation>Převzít pohled ze schránky</translation>
    </message>
    <message>
        <source>S&amp;tatistics</source>
        <translation>S&amp;tatistika</translation>
    </message>
    <message>
        <source>Frames/s, rays/s, resolution, polygons</source>
        <translation>Snímky za sekundu, paprsky za sekundu, rozlišení, trojúhelníky</translation>
    </message>
    <message>
        <source>S&amp;top server</source>
        <translation>&amp;Zastavit server</translation>
    </message>
    <message>
        <source>End the server</source>
        <translation>Ukončit server</translation>
    </message>
    <message>
        <source>P&amp;ause server</source>
        <translation>Poz&amp;astavit server</translation>
    </message>
    <message>
        <source>Finish the image, then draw no more until this is off again</source>
        <translation>Dokončit obraz a další nekreslit, dokud se volba nevypne</translation>
    </message>
    <message>
        <source>&amp;Ping server</source>
        <translation>Od&amp;ezva serveru</translation>
    </message>
    <message>
        <source>Test whether it answers</source>
        <translation>Odpovídá server?</translation>
    </message>
    <message>
        <source>&amp;Restart server</source>
        <translation>&amp;Restartovat server</translation>
    </message>
    <message>
        <source>Start the server again with the same scene and camera</source>
        <translation>Znovu spustit server se stejnou scénou a kamerou</translation>
    </message>
    <message>
        <source>Stretch to &amp;window</source>
        <translation>&amp;Roztáhnout na okno</translation>
    </message>
    <message>
        <source>Fill the whole window, whatever the aspect ratio</source>
        <translation>Vyplnit celé okno bez ohledu na poměr stran</translation>
    </message>
    <message>
        <source>&amp;Smooth scaling</source>
        <translation>&amp;Vyhlazovat zvětšení</translation>
    </message>
    <message>
        <source>Filter the image where it does not have the window&apos;s size</source>
        <translation>Filtrovat obraz, který nemá velikost okna</translation>
    </message>
    <message>
        <source>Show &amp;overlay</source>
        <translation>Zobrazit ú&amp;daje</translation>
    </message>
    <message>
        <source>Frames/s, resolution, mode and state in the corner</source>
        <translation>Snímky za sekundu, rozlišení, režim a stav v rohu</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Celá obrazovka</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Využít celou obrazovku</translation>
    </message>
    <message>
        <source>When the camera rests, render the view in higher quality</source>
        <translation>Když kamera stojí, vykreslit pohled ve vyšší kvalitě</translation>
    </message>
    <message>
        <source>P&amp;references…</source>
        <translation>Př&amp;edvolby…</translation>
    </message>
    <message>
        <source>Behaviour, image and keys</source>
        <translation>Chování, obraz a klávesy</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Klávesy</translation>
    </message>
    <message>
        <source>All keys on one page</source>
        <translation>Všechny klávesy na jedné stránce</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>&amp;O programu</translation>
    </message>
    <message>
        <source>About this program</source>
        <translation>O tomto programu</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Soubor</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Úpr&amp;avy</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>Re&amp;nder</source>
        <translation>V&amp;ykreslit</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Okno</translation>
    </message>
    <message>
        <source>&amp;Server</source>
        <translation>S&amp;erver</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Nápo&amp;věda</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Dvojité kliknutí</translation>
    </message>
    <message>
        <source>Look there</source>
        <translation>Pohled na místo</translation>
    </message>
    <message>
        <source>Alt+digit</source>
        <translation>Alt+číslice</translation>
    </message>
    <message>
        <source>Go to a bookmark</source>
        <translation>Přejít na záložku</translation>
    </message>
    <message>
        <source>Re&amp;nder…</source>
        <translation>Vykreslit do soub&amp;oru…</translation>
    </message>
    <message>
        <source>Render the view, a scene or a recorded list into a file</source>
        <translation>Vykreslit pohled, scénu nebo záznam do souboru</translation>
    </message>
    <message>
        <source>Build &amp;kd-tree…</source>
        <translation>Postavit &amp;kd-strom…</translation>
    </message>
    <message>
        <source>Write a model and its kd-tree to a .bsp file, which loads quickly</source>
        <translation>Zapsat model a jeho kd-strom do souboru .bsp, který se rychle načítá</translation>
    </message>
    <message>
        <source>&amp;Jobs</source>
        <translation>Úlo&amp;hy</translation>
    </message>
    <message>
        <source>Running and queued jobs</source>
        <translation>Běžící a čekající úlohy</translation>
    </message>
    <message>
        <source>Reset ca&amp;mera</source>
        <translation>Výchozí ka&amp;mera</translation>
    </message>
    <message>
        <source>The view that the scene names</source>
        <translation>Pohled podle samotné scény</translation>
    </message>
    <message>
        <source>Keep the current view; Alt and a digit go back to it</source>
        <translation>Uchovat aktuální pohled; Alt a číslice se k němu vrátí</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Vrátit změ&amp;nu</translation>
    </message>
    <message>
        <source>Take the last change of settings, lights or camera back</source>
        <translation>Vrátit poslední změnu nastavení, světel nebo kamery</translation>
    </message>
    <message>
        <source>Re&amp;do</source>
        <translation>Znov&amp;u provést</translation>
    </message>
    <message>
        <source>Make it again</source>
        <translation>Provést změnu znovu</translation>
    </message>
    <message>
        <source>S&amp;ettings panel</source>
        <translation>Panel na&amp;stavení</translation>
    </message>
    <message>
        <source>All settings of the viewport</source>
        <translation>Všechna nastavení živého obrazu</translation>
    </message>
    <message>
        <source>&amp;Lights panel</source>
        <translation>Panel světe&amp;l</translation>
    </message>
    <message>
        <source>&amp;Bookmarks panel</source>
        <translation>Panel &amp;záložek</translation>
    </message>
    <message>
        <source>Views that you keep</source>
        <translation>Uchované pohledy</translation>
    </message>
    <message>
        <source>Record the camera, 30 times a second</source>
        <translation>Zaznamenávat kameru, 30krát za sekundu</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>nejméně %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 až %2</translation>
    </message>
    <message>
        <source>default: %1</source>
        <translation>výchozí: %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>zapnuto</translation>
    </message>
    <message>
        <source>off</source>
        <translation>vypnuto</translation>
    </message>
    <message>
        <source>Capture mouse and keyboard</source>
        <translation>Zachytit myš a klávesnici</translation>
    </message>
    <message>
        <source>Release them</source>
        <translation>Uvolnit je</translation>
    </message>
    <message>
        <source>Messages of the server</source>
        <translation>Zprávy serveru</translation>
    </message>
    <message>
        <source>%1 (and others like this: %2)</source>
        <translation>%1 (a další podobná: %2)</translation>
    </message>
    <message>
        <source>Walking</source>
        <translation>Chůze</translation>
    </message>
    <message>
        <source>Flying</source>
        <translation>Létání</translation>
    </message>
    <message>
        <source>Bloom: on</source>
        <translation>Záře: zapnuta</translation>
    </message>
    <message>
        <source>Bloom: off</source>
        <translation>Záře: vypnuta</translation>
    </message>
    <message>
        <source>Light %1: on</source>
        <translation>Světlo %1: zapnuto</translation>
    </message>
    <message>
        <source>Light %1: off</source>
        <translation>Světlo %1: vypnuto</translation>
    </message>
    <message>
        <source>Environment map %1</source>
        <translation>Mapa prostředí %1</translation>
    </message>
    <message>
        <source>There is no light %1.</source>
        <translation>Světlo %1 neexistuje.</translation>
    </message>
    <message>
        <source>There is no environment map %1.</source>
        <translation>Mapa prostředí %1 neexistuje.</translation>
    </message>
    <message>
        <source>Further warnings: %1</source>
        <translation>Další varování: %1</translation>
    </message>
    <message>
        <source>sharpening</source>
        <translation>zaostřuje se</translation>
    </message>
    <message>
        <source>No floor here: walking on an invisible ground</source>
        <translation>Není tu podlaha: chodíte po neviditelné zemi</translation>
    </message>
    <message>
        <source>There is no room to stand here, or no floor below; move elsewhere first.</source>
        <translation>Není tu místo k stání nebo pod vámi není podlaha; přesuňte se jinam.</translation>
    </message>
    <message>
        <source>Ctrl+double click</source>
        <translation>Ctrl+dvojité kliknutí</translation>
    </message>
    <message>
        <source>Focus the lens there</source>
        <translation>Zaostřit na místo</translation>
    </message>
    <message>
        <source>How much the camera sees, as an angle or a lens; Ctrl and the wheel change it, too</source>
        <translation>Kolik kamera vidí, jako úhel nebo objektiv; mění to i Ctrl s kolečkem</translation>
    </message>
    <message>
        <source>%1 is up (guessed, %2).</source>
        <translation>Vzhůru míří %1 (odhad, %2).</translation>
    </message>
    <message>
        <source>Up a&amp;xis and unit…</source>
        <translation>Svislá osa a &amp;jednotka…</translation>
    </message>
    <message>
        <source>Which axis of the model is up, and how long a unit of it is</source>
        <translation>Která osa modelu míří vzhůru a jak dlouhá je jeho jednotka</translation>
    </message>
    <message>
        <source>1 unit = %1 m (guessed, %2).</source>
        <translation>1 jednotka = %1 m (odhad, %2).</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Uložit</translation>
    </message>
    <message>
        <source>Write the scene as it is now to its file</source>
        <translation>Zapsat scénu, jak teď je, do jejího souboru</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Uložit &amp;jako…</translation>
    </message>
    <message>
        <source>Write the scene as it is now to another file, and go on with that</source>
        <translation>Zapsat scénu, jak teď je, do jiného souboru a pokračovat s ním</translation>
    </message>
    <message>
        <source>Pac&amp;k with its files…</source>
        <translation>&amp;Zabalit se soubory…</translation>
    </message>
    <message>
        <source>Copy the scene and all that it needs to a folder that can be moved</source>
        <translation>Zkopírovat scénu a vše, co potřebuje, do složky, kterou lze přesunout</translation>
    </message>
    <message>
        <source>&amp;Model panel</source>
        <translation>Panel &amp;modelu</translation>
    </message>
    <message>
        <source>Parts and materials of the model; a right click on the image selects them</source>
        <translation>Části a materiály modelu; vybírá je pravé tlačítko myši v obraze</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Pravé tlačítko</translation>
    </message>
    <message>
        <source>Select a part and its material</source>
        <translation>Výběr části a jejího materiálu</translation>
    </message>
    <message>
        <source>Mar&amp;ks of lights</source>
        <translation>Značk&amp;y světel</translation>
    </message>
    <message>
        <source>Show where lights are: click a mark to select its light, drag it to move the light</source>
        <translation>Ukázat, kde jsou světla: kliknutí na značku světlo vybere, tažení je přesune</translation>
    </message>
    <message>
        <source>&amp;Sky and sun</source>
        <translation>&amp;Obloha a slunce</translation>
    </message>
    <message>
        <source>Light the scene by a sky with a sun, in place of its lights</source>
        <translation>Osvětlí scénu oblohou se sluncem místo jejích světel</translation>
    </message>
    <message>
        <source>S&amp;tudio</source>
        <translation>S&amp;tudio</translation>
    </message>
    <message>
        <source>Light it by soft lights before white walls, in place of its lights</source>
        <translation>Osvětlí ji měkkými světly před bílými stěnami místo jejích světel</translation>
    </message>
    <message>
        <source>&amp;Headlight</source>
        <translation>Světlo u &amp;diváka</translation>
    </message>
    <message>
        <source>Light it by one light beside you, in place of its lights</source>
        <translation>Osvětlí ji jedním světlem vedle vás místo jejích světel</translation>
    </message>
    <message>
        <source>&amp;Environment map…</source>
        <translation>&amp;Mapa prostředí…</translation>
    </message>
    <message>
        <source>Let an image of all directions surround and light the scene</source>
        <translation>Obklopí a osvětlí scénu obrázkem všech směrů</translation>
    </message>
    <message>
        <source>&amp;No background</source>
        <translation>&amp;Žádné pozadí</translation>
    </message>
    <message>
        <source>Neither sky nor environment map</source>
        <translation>Ani obloha, ani mapa prostředí</translation>
    </message>
    <message>
        <source>Lights, the sky and environment maps</source>
        <translation>Světla, obloha a mapy prostředí</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>Svě&amp;tlo</translation>
    </message>
    <message>
        <source>When the camera rests, render all light, also from surface to surface</source>
        <translation>Když kamera stojí, vykreslit všechno světlo, i mezi povrchy</translation>
    </message>
    <message>
        <source>Copy &amp;image</source>
        <translation>Kopírovat o&amp;braz</translation>
    </message>
    <message>
        <source>Copy the image that is shown</source>
        <translation>Zkopírovat obraz, který je vidět</translation>
    </message>
    <message>
        <source>samples: %1</source>
        <translation>vzorků: %1</translation>
    </message>
    <message>
        <source>path tracing</source>
        <translation>sledování cest</translation>
    </message>
    <message>
        <source>Whitted ray tracing</source>
        <translation>sledování paprsků (Whitted)</translation>
    </message>
    <message>
        <source>%1, samples per pixel: %2</source>
        <translation>%1, vzorků na pixel: %2</translation>
    </message>
    <message>
        <source>Share in a &amp;browser…</source>
        <translation>Sdílet v pro&amp;hlížeči…</translation>
    </message>
    <message>
        <source>Let others look at it, and walk in it, in web pages</source>
        <translation>Ostatní se mohou dívat a chodit na webových stránkách</translation>
    </message>
    <message>
        <source>All &amp;panels</source>
        <translation>Všechny &amp;panely</translation>
    </message>
    <message>
        <source>Hide all panels, and show them again</source>
        <translation>Skrýt všechny panely a zase je ukázat</translation>
    </message>
    <message>
        <source>&amp;Orbit</source>
        <translation>&amp;Otáčet model</translation>
    </message>
    <message>
        <source>A drag turns the model, Shift moves it, the wheel goes nearer; without, a click takes the mouse, which looks around</source>
        <translation>Tažení model otáčí, se Shiftem posouvá, kolečko přibližuje; jinak kliknutí převezme myš, která se rozhlíží</translation>
    </message>
    <message>
        <source>All of the model, from the side where you are</source>
        <translation>Celý model ze strany, kde jste</translation>
    </message>
    <message>
        <source>From the front, a&amp;slant</source>
        <translation>Zepředu ši&amp;kmo</translation>
    </message>
    <message>
        <source>All of the model, from the front, the right and a little above</source>
        <translation>Celý model zepředu, zprava a trochu shora</translation>
    </message>
    <message>
        <source>From the &amp;front</source>
        <translation>Ze&amp;předu</translation>
    </message>
    <message>
        <source>All of the model, from its front</source>
        <translation>Celý model zepředu</translation>
    </message>
    <message>
        <source>From the &amp;back</source>
        <translation>Ze&amp;zadu</translation>
    </message>
    <message>
        <source>All of the model, from its back</source>
        <translation>Celý model zezadu</translation>
    </message>
    <message>
        <source>From the &amp;right</source>
        <translation>Zp&amp;rava</translation>
    </message>
    <message>
        <source>All of the model, from its right side</source>
        <translation>Celý model zprava</translation>
    </message>
    <message>
        <source>From the &amp;left</source>
        <translation>Zl&amp;eva</translation>
    </message>
    <message>
        <source>All of the model, from its left side</source>
        <translation>Celý model zleva</translation>
    </message>
    <message>
        <source>From &amp;top</source>
        <translation>&amp;Shora</translation>
    </message>
    <message>
        <source>All of the model, from above</source>
        <translation>Celý model shora</translation>
    </message>
    <message>
        <source>From b&amp;elow</source>
        <translation>Z&amp;dola</translation>
    </message>
    <message>
        <source>All of the model, from below</source>
        <translation>Celý model zdola</translation>
    </message>
    <message>
        <source>Field of &amp;view…</source>
        <translation>&amp;Úhel záběru…</translation>
    </message>
    <message>
        <source>Add boo&amp;kmark</source>
        <translation>Přidat zá&amp;ložku</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Po&amp;hled</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Tažení</translation>
    </message>
    <message>
        <source>While orbiting: turn the model</source>
        <translation>Při otáčení: otočit model</translation>
    </message>
    <message>
        <source>Shift+drag, middle button</source>
        <translation>Shift+tažení, prostřední tlačítko</translation>
    </message>
    <message>
        <source>While orbiting: move the model</source>
        <translation>Při otáčení: posunout model</translation>
    </message>
    <message>
        <source>&amp;Whole model</source>
        <translation>&amp;Celý model</translation>
    </message>
    <message>
        <source>Show &amp;cube</source>
        <translation>Zobrazit &amp;krychli</translation>
    </message>
    <message>
        <source>The direction of the view in the corner, and whether you orbit, walk or fly</source>
        <translation>Směr pohledu v rohu, a zda se model otáčí, chodí se nebo létá</translation>
    </message>
    <message>
        <source>Selected &amp;part</source>
        <translation>&amp;Vybraná část</translation>
    </message>
    <message>
        <source>The part that is selected, from the side where you are</source>
        <translation>Vybraná část ze strany, kde jste</translation>
    </message>
    <message>
        <source>Materials guessed by name: %1 (%2).</source>
        <translation>Materiály odhadnuté podle názvu: %1 (%2).</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>otáčení</translation>
    </message>
    <message>
        <source>left button turns, Shift moves</source>
        <translation>levé tlačítko otáčí, se Shiftem posouvá</translation>
    </message>
    <message>
        <source>Middle button, Shift+drag</source>
        <translation>Prostřední tlačítko, Shift+tažení</translation>
    </message>
    <message>
        <source>Right button, wheel</source>
        <translation>Pravé tlačítko, kolečko</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Prostřední tlačítko</translation>
    </message>
    <message>
        <source>Shift+middle button</source>
        <translation>Shift+prostřední tlačítko</translation>
    </message>
    <message>
        <source>Ctrl+middle button, wheel</source>
        <translation>Ctrl+prostřední tlačítko, kolečko</translation>
    </message>
    <message>
        <source>While orbiting: go nearer</source>
        <translation>Při otáčení: přiblížit</translation>
    </message>
    <message>
        <source>While orbiting: look there</source>
        <translation>Při otáčení: podívat se tam</translation>
    </message>
    <message>
        <source>as f3d: left turns, middle moves, right goes nearer</source>
        <translation>jako f3d: levé otáčí, prostřední posouvá, pravé přibližuje</translation>
    </message>
    <message>
        <source>as Blender: middle turns, Shift moves, Ctrl goes nearer</source>
        <translation>jako Blender: prostřední otáčí, se Shiftem posouvá, s Ctrl přibližuje</translation>
    </message>
    <message>
        <source>Wal&amp;k</source>
        <translation>Chod&amp;it</translation>
    </message>
    <message>
        <source>On the ground, by the keys and the mouse; F does it, too</source>
        <translation>Po zemi, klávesami a myší; totéž dělá F</translation>
    </message>
    <message>
        <source>Fl&amp;y</source>
        <translation>Lé&amp;tat</translation>
    </message>
    <message>
        <source>Anywhere, by the keys and the mouse</source>
        <translation>Kamkoli, klávesami a myší</translation>
    </message>
    <message>
        <source>At rest: &amp;live frame</source>
        <translation>V klidu: ži&amp;vý snímek</translation>
    </message>
    <message>
        <source>When the camera rests, show what the server draws; once more: refine it again</source>
        <translation>Když kamera stojí, ukázat, co kreslí server; podruhé: zase zjemňovat</translation>
    </message>
    <message>
        <source>At rest: re&amp;fined</source>
        <translation>V klidu: &amp;zjemněný obraz</translation>
    </message>
    <message>
        <source>At rest: &amp;global illumination</source>
        <translation>V klidu: &amp;globální osvětlení</translation>
    </message>
    <message>
        <source>Tool ba&amp;r</source>
        <translation>Panel nástro&amp;jů</translation>
    </message>
    <message>
        <source>The buttons below the menus</source>
        <translation>Tlačítka pod nabídkami</translation>
    </message>
    <message>
        <source>Live frame</source>
        <translation>Živý snímek</translation>
    </message>
    <message>
        <source>Refined</source>
        <translation>Zjemněný obraz</translation>
    </message>
    <message>
        <source>Global illumination</source>
        <translation>Globální osvětlení</translation>
    </message>
    <message>
        <source>Show &amp;noise that is left</source>
        <translation>Zobrazit zbývající š&amp;um</translation>
    </message>
    <message>
        <source>Colour an image that a net denoised by its error, and mark where that is largest</source>
        <translation>Obarvit obraz zbavený šumu sítí podle jeho chyby a označit, kde je největší</translation>
    </message>
    <message>
        <source>±%1 of 255</source>
        <translation>±%1 z 255</translation>
    </message>
    <message>
        <source>error, of 255</source>
        <translation>chyba, z 255</translation>
    </message>
    <message>
        <source>largest: ±%1</source>
        <translation>největší: ±%1</translation>
    </message>
    <message>
        <source>Indirect light is rendered, and these lights stand in for it: %1.</source>
        <translation>Nepřímé světlo se počítá a tato světla ho jen nahrazují: %1.</translation>
    </message>
    <message>
        <source>indirect light ±%1 %</source>
        <translation>nepřímé světlo ±%1 %</translation>
    </message>
    <message>
        <source>Sect&amp;ions panel</source>
        <translation>Panel ř&amp;ezů</translation>
    </message>
    <message>
        <source>Planes that cut the model open</source>
        <translation>Roviny, které model rozříznou</translation>
    </message>
    <message>
        <source>P&amp;lan…</source>
        <translation>P&amp;lán…</translation>
    </message>
    <message>
        <source>Draw a plan, a section or an elevation to scale</source>
        <translation>Nakreslí půdorys, řez nebo pohled v měřítku</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Měřit</translation>
    </message>
    <message>
        <source>Click points, which corners and edges catch: distances, angles, heights, areas, volumes</source>
        <translation>Klikat na body, které přitahují rohy a hrany: vzdálenosti, úhly, výšky, plochy, objemy</translation>
    </message>
    <message>
        <source>Me&amp;asures panel</source>
        <translation>P&amp;anel měr</translation>
    </message>
    <message>
        <source>Measures that are kept, and their unit</source>
        <translation>Uchované míry a jejich jednotka</translation>
    </message>
    <message>
        <source>Labels o&amp;f measures</source>
        <translation>Pop&amp;isky měr</translation>
    </message>
    <message>
        <source>Show the measures that are kept over the image</source>
        <translation>Zobrazit uchované míry přes obraz</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Vzdálenost</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Řetězec</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Úhel</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Plocha</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Objem</translation>
    </message>
    <message>
        <source>Light &amp;meter</source>
        <translation>&amp;Světloměr</translation>
    </message>
    <message>
        <source>Show at the pointer how much light falls there, and how bright it is</source>
        <translation>U ukazatele ukáže, kolik světla tam dopadá a jak je to jasné</translation>
    </message>
    <message>
        <source>some light has no absolute unit</source>
        <translation>část světla nemá absolutní jednotku</translation>
    </message>
    <message>
        <source>&amp;Handles of sections</source>
        <translation>Úc&amp;hyty řezů</translation>
    </message>
    <message>
        <source>Drag the planes that cut the model open, also while their panel is closed</source>
        <translation>Táhnout rovinami, které model otevírají, i když je jejich panel zavřený</translation>
    </message>
    <message>
        <source>Plan in the &amp;corner</source>
        <translation>Plán v ro&amp;hu</translation>
    </message>
    <message>
        <source>A small plan of the storey where you are: a click goes there, a drag looks there</source>
        <translation>Malý plán podlaží, kde jste: kliknutí tam přejde, tažení tam otočí pohled</translation>
    </message>
    <message>
        <source>To the &amp;ground floor</source>
        <translation>Do přízemí &amp;budovy</translation>
    </message>
    <message>
        <source>Stand on the ground floor, where you are</source>
        <translation>Postavit se do přízemí na místě, kde jste</translation>
    </message>
    <message>
        <source>One storey &amp;up</source>
        <translation>O pod&amp;laží výš</translation>
    </message>
    <message>
        <source>Stand on the storey above, where you are</source>
        <translation>Postavit se o podlaží výš na místě, kde jste</translation>
    </message>
    <message>
        <source>One storey &amp;down</source>
        <translation>O podlaží &amp;níž</translation>
    </message>
    <message>
        <source>Stand on the storey below, where you are</source>
        <translation>Postavit se o podlaží níž na místě, kde jste</translation>
    </message>
    <message>
        <source>Strip of &amp;views</source>
        <translation>Pás &amp;uložených pohledů</translation>
    </message>
    <message>
        <source>Your bookmarks as images beside each other: a click goes there</source>
        <translation>Záložky jako obrázky vedle sebe: kliknutí tam přejde</translation>
    </message>
    <message>
        <source>Add a &amp;note</source>
        <translation>Přid&amp;at poznámku</translation>
    </message>
    <message>
        <source>Click a place of the model and write what is to be said of it</source>
        <translation>Klepněte na místo modelu a napište, co k němu chcete říci</translation>
    </message>
    <message>
        <source>Notes an&amp;d comments</source>
        <translation>Pa&amp;nel poznámek</translation>
    </message>
    <message>
        <source>Texts at places of the model</source>
        <translation>Texty u míst modelu</translation>
    </message>
    <message>
        <source>Notes o&amp;ver the image</source>
        <translation>Zo&amp;brazit poznámky</translation>
    </message>
    <message>
        <source>Show the numbers of notes over the image</source>
        <translation>Zobrazit čísla poznámek v obraze</translation>
    </message>
    <message>
        <source>&amp;Add a key frame</source>
        <translation>Přidat klíčov&amp;ý snímek</translation>
    </message>
    <message>
        <source>Let the flight that is selected end at the current view, or begin one</source>
        <translation>Vybraný let ukončit nynějším pohledem nebo nový začít</translation>
    </message>
    <message>
        <source>Fli&amp;ghts panel</source>
        <translation>Panel let&amp;ů</translation>
    </message>
    <message>
        <source>Paths of the camera by key frames, and films of them</source>
        <translation>Dráhy kamery podle klíčových snímků a filmy z nich</translation>
    </message>
    <message>
        <source>Record the &amp;walk</source>
        <translation>Nahrávat &amp;průchod</translation>
    </message>
    <message>
        <source>Record the camera from now on, or end that; also while walking</source>
        <translation>Od této chvíle nahrávat kameru, nebo to ukončit; i při chůzi</translation>
    </message>
    <message>
        <source>Compare &amp;with this image</source>
        <translation>&amp;Porovnávat s tímto obrazem</translation>
    </message>
    <message>
        <source>Keep the image that is shown, to compare others with it</source>
        <translation>Uchovat zobrazený obraz, aby se s ním daly porovnat jiné</translation>
    </message>
    <message>
        <source>Compare: &amp;divider</source>
        <translation>Porovnat: &amp;dělicí čára</translation>
    </message>
    <message>
        <source>The kept image left of a divider that can be dragged</source>
        <translation>Uchovaný obraz vlevo od čáry, kterou lze táhnout</translation>
    </message>
    <message>
        <source>Compare: &amp;in turns</source>
        <translation>Porovnat: &amp;střídavě</translation>
    </message>
    <message>
        <source>The kept image and the one that is shown, one after the other</source>
        <translation>Uchovaný a zobrazený obraz, jeden po druhém</translation>
    </message>
    <message>
        <source>Compare: diff&amp;erence</source>
        <translation>Porovnat: rozdí&amp;l</translation>
    </message>
    <message>
        <source>How much the image differs from the kept one, brightened, with figures</source>
        <translation>Jak moc se obraz liší od uchovaného, zesvětleně a s čísly</translation>
    </message>
    <message>
        <source>&amp;Keep as a variant…</source>
        <translation>U&amp;ložit jako variantu…</translation>
    </message>
    <message>
        <source>Keep the materials, parts, lights and the sky as they are now under a name</source>
        <translation>Uložit pod jménem materiály, součásti, světla a oblohu, jak jsou teď</translation>
    </message>
</context>
<context>
    <name>gui::AboutDialog</name>
    <message>
        <source>About</source>
        <translation>O programu</translation>
    </message>
    <message>
        <source>&lt;h3&gt;rtsuite&lt;/h3&gt;&lt;p&gt;Interactive ray tracing.&lt;/p&gt;&lt;p&gt;Open a scene or a model and walk in it, with shadows, mirrors and glass traced ray by ray by the processor alone.&lt;/p&gt;&lt;p&gt;After &lt;i&gt;Ray Tracing Algorithm For Interactive Applications&lt;/i&gt;.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;rtsuite&lt;/h3&gt;&lt;p&gt;Interaktivní sledování paprsků.&lt;/p&gt;&lt;p&gt;Otevřete scénu nebo model a projděte se v něm. Stíny, zrcadla i sklo počítá paprsek po paprsku samotný procesor.&lt;/p&gt;&lt;p&gt;Podle práce &lt;i&gt;Ray Tracing Algorithm For Interactive Applications&lt;/i&gt;.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>
Qt %1</source>
        <translation>
Qt %1</translation>
    </message>
</context>
<context>
    <name>gui::Actions</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>Ne&amp;dávno otevřené</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Vymazat</translation>
    </message>
    <message>
        <source>Exam&amp;ples</source>
        <translation>&amp;Příklady</translation>
    </message>
    <message>
        <source>&amp;Built-in environments</source>
        <translation>Dodaná &amp;prostředí</translation>
    </message>
    <message>
        <source>&amp;Variants</source>
        <translation>&amp;Varianty</translation>
    </message>
</context>
<context>
    <name>gui::BarOperations</name>
    <message>
        <source>Tool bar</source>
        <translation>Panel nástrojů</translation>
    </message>
    <message>
        <source>Light the scene anew</source>
        <translation>Nasvítit scénu znovu</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Osvětlení</translation>
    </message>
</context>
<context>
    <name>gui::BookmarkOperations</name>
    <message>
        <source>delete “%1”</source>
        <translation>smazat „%1“</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>Záložky</translation>
    </message>
    <message>
        <source>Bookmark “%1” added. Alt+%2 goes there.</source>
        <translation>Záložka „%1“ přidána. Vrátí vás Alt+%2.</translation>
    </message>
    <message>
        <source>Bookmark “%1” added.</source>
        <translation>Záložka „%1“ přidána.</translation>
    </message>
    <message>
        <source>There is no bookmark %1.</source>
        <translation>Záložka %1 neexistuje.</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Pohledy</translation>
    </message>
    <message>
        <source>“%1” is the current view now.</source>
        <translation>„%1“ je teď aktuální pohled.</translation>
    </message>
    <message>
        <source>replace “%1”</source>
        <translation>nahradit „%1“</translation>
    </message>
    <message>
        <source>Bookmarks of the scene come first.</source>
        <translation>Záložky scény jsou vždy první.</translation>
    </message>
    <message>
        <source>move “%1”</source>
        <translation>přesunout „%1“</translation>
    </message>
    <message>
        <source>There is a bookmark “%1” already.</source>
        <translation>Záložka „%1“ už existuje.</translation>
    </message>
    <message>
        <source>rename “%1”</source>
        <translation>přejmenovat „%1“</translation>
    </message>
</context>
<context>
    <name>gui::BookmarkStore</name>
    <message>
        <source>Place %1</source>
        <translation>Místo %1</translation>
    </message>
    <message>
        <source>No scene is shown.</source>
        <translation>Není zobrazena žádná scéna.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>Soubor %1 nelze zapsat: %2</translation>
    </message>
    <message>
        <source>no such folder</source>
        <translation>složka neexistuje</translation>
    </message>
</context>
<context>
    <name>gui::BookmarksPanel</name>
    <message>
        <source>Bookmarks</source>
        <translation>Záložky</translation>
    </message>
    <message>
        <source>Keep the current view</source>
        <translation>Uchovat aktuální pohled</translation>
    </message>
    <message>
        <source>Go to this view; also Enter or a double click</source>
        <translation>Přejít na tento pohled; také Enter nebo dvojité kliknutí</translation>
    </message>
    <message>
        <source>Also by F2</source>
        <translation>Také klávesou F2</translation>
    </message>
    <message>
        <source>Can be undone</source>
        <translation>Lze vrátit</translation>
    </message>
    <message>
        <source>%1
Alt+%2</source>
        <translation>%1
Alt+%2</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Přidat</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Přejít</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Přejmenovat</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Smazat</translation>
    </message>
</context>
<context>
    <name>gui::BridgeProcess</name>
    <message>
        <source>RTBridge cannot be started: %1</source>
        <translation>RTBridge nelze spustit: %1</translation>
    </message>
    <message>
        <source>The program RTBridge was found neither beside this one nor in PATH. It is part of the package, and of a build that finds libturbojpeg and libdeflate.</source>
        <translation>Program RTBridge nebyl nalezen vedle tohoto programu ani v PATH. Je součástí balíčku a sestavení, které najde libturbojpeg a libdeflate.</translation>
    </message>
    <message>
        <source>RTBridge was killed or has crashed (signal %1).</source>
        <translation>RTBridge byl násilně ukončen nebo havaroval (signál %1).</translation>
    </message>
    <message>
        <source>RTBridge ended with exit code %1.</source>
        <translation>RTBridge skončil s návratovým kódem %1.</translation>
    </message>
</context>
<context>
    <name>gui::BuildDialog</name>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Output file</source>
        <translation>Výstupní soubor</translation>
    </message>
    <message>
        <source>kd-trees (*.bsp);;All files (*)</source>
        <translation>kd-stromy (*.bsp);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>&amp;Fast build</source>
        <translation>Rychlá stav&amp;ba</translation>
    </message>
    <message>
        <source>&amp;Report on model, tree and times</source>
        <translation>Zpráv&amp;a o modelu, stromu a časech</translation>
    </message>
    <message>
        <source>Build kd-tree</source>
        <translation>Postavit kd-strom</translation>
    </message>
    <message>
        <source>Quality of the fast build</source>
        <translation>Kvalita rychlé stavby</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogram</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádný</translation>
    </message>
    <message>
        <source> bands</source>
        <translation> pásem</translation>
    </message>
    <message>
        <source>Mode&amp;l:</source>
        <translation>&amp;Model:</translation>
    </message>
    <message>
        <source>&amp;Output:</source>
        <translation>&amp;Výstup:</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>&amp;Kvalita:</translation>
    </message>
    <message>
        <source>&amp;Histogram:</source>
        <translation>&amp;Histogram:</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Postavit</translation>
    </message>
    <message>
        <source>Choose a model.</source>
        <translation>Vyberte model.</translation>
    </message>
    <message>
        <source>Name the file to write.</source>
        <translation>Zadejte výstupní soubor.</translation>
    </message>
    <message>
        <source>The output would overwrite the model.</source>
        <translation>Výstup by přepsal model.</translation>
    </message>
</context>
<context>
    <name>gui::CameraOperations</name>
    <message>
        <source>The camera was written to %1.</source>
        <translation>Kamera byla zapsána do %1.</translation>
    </message>
    <message>
        <source>Import a camera</source>
        <translation>Importovat kameru</translation>
    </message>
    <message>
        <source>Cameras (*.cam);;All files (*)</source>
        <translation>Kamery (*.cam);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>The camera was copied.</source>
        <translation>Kamera byla zkopírována.</translation>
    </message>
    <message>
        <source>The camera was pasted.</source>
        <translation>Kamera byla vložena.</translation>
    </message>
    <message>
        <source>The clipboard holds no camera.</source>
        <translation>Ve schránce není kamera.</translation>
    </message>
    <message>
        <source>The image was written to %1 (%2).</source>
        <translation>Obraz byl zapsán do %1 (%2).</translation>
    </message>
    <message>
        <source>The live frame was written to %1.</source>
        <translation>Živý snímek byl zapsán do %1.</translation>
    </message>
    <message>
        <source>The live frame was copied.</source>
        <translation>Živý snímek byl zkopírován.</translation>
    </message>
    <message>
        <source>The image was copied (%1).</source>
        <translation>Obraz byl zkopírován (%1).</translation>
    </message>
</context>
<context>
    <name>gui::Comparison</name>
    <message>
        <source>kept</source>
        <translation>uchovaný</translation>
    </message>
    <message>
        <source>now</source>
        <translation>nyní</translation>
    </message>
    <message>
        <source>Difference: mean %1, largest %2 of 255</source>
        <translation>Rozdíl: průměrný %1, největší %2 z 255</translation>
    </message>
    <message>
        <source>%1; shown %2 times as bright</source>
        <translation>%1; zobrazen %2× jasněji</translation>
    </message>
</context>
<context>
    <name>gui::ComparisonOperations</name>
    <message>
        <source>This image is kept. The menu Render compares others with it.</source>
        <translation>Tento obraz je uchován. Nabídka Vykreslit s ním porovná jiné.</translation>
    </message>
    <message>
        <source>Nothing is kept to compare with: press %1 first.</source>
        <translation>Není uchováno nic k porovnání: nejdřív stiskněte %1.</translation>
    </message>
</context>
<context>
    <name>gui::ConfigureDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Předvolby</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>&amp;Obecné</translation>
    </message>
    <message>
        <source>&amp;Mouse</source>
        <translation>&amp;Myš</translation>
    </message>
    <message>
        <source>Image folder</source>
        <translation>Složka pro obrázky</translation>
    </message>
    <message>
        <source>Image &amp;folder:</source>
        <translation>&amp;Složka pro obrázky:</translation>
    </message>
    <message>
        <source>&amp;Keep servers running when the window closes</source>
        <translation>&amp;Nechat servery běžet po zavření okna</translation>
    </message>
    <message>
        <source>Viewport fo&amp;llows the window&apos;s size</source>
        <translation>Ž&amp;ivý obraz má velikost okna</translation>
    </message>
    <message>
        <source>Frame &amp;time in motion:</source>
        <translation>&amp;Doba snímku za pohybu:</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>&amp;Quick render, anti-aliasing:</source>
        <translation>&amp;Rychlé vykreslení, vyhlazování hran:</translation>
    </message>
    <message>
        <source>Quick render, &amp;bloom:</source>
        <translation>Rychlé vykreslení, &amp;záře:</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> bodů</translation>
    </message>
    <message>
        <source>&amp;H exports anti-aliasing:</source>
        <translation>&amp;H exportuje vyhlazování hran:</translation>
    </message>
    <message>
        <source>H exports bl&amp;oom:</source>
        <translation>H &amp;exportuje záři:</translation>
    </message>
    <message>
        <source>In&amp;vert up and down</source>
        <translation>&amp;Převrátit nahoru a dolů</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádná</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>podle systému</translation>
    </message>
    <message>
        <source>light</source>
        <translation>světlý</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>tmavý</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>&amp;Vzhled:</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Jazyk:</translation>
    </message>
    <message>
        <source>%1 % of the window</source>
        <translation>%1 % okna</translation>
    </message>
    <message>
        <source>Smaller images are drawn faster</source>
        <translation>Menší obraz se kreslí rychleji</translation>
    </message>
    <message>
        <source>&amp;Size of the viewport:</source>
        <translation>&amp;Velikost živého obrazu:</translation>
    </message>
    <message>
        <source>° per pixel</source>
        <translation>° na pixel</translation>
    </message>
    <message>
        <source>&amp;Sensitivity:</source>
        <translation>&amp;Citlivost:</translation>
    </message>
    <message>
        <source>&amp;Image</source>
        <translation>O&amp;braz</translation>
    </message>
    <message>
        <source>K&amp;eys</source>
        <translation>&amp;Klávesy</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Mo&amp;del cache:</source>
        <translation>&amp;Cache modelů:</translation>
    </message>
    <message>
        <source>same as viewport</source>
        <translation>jako živý obraz</translation>
    </message>
    <message>
        <source>on</source>
        <translation>zapnuto</translation>
    </message>
    <message>
        <source>off</source>
        <translation>vypnuto</translation>
    </message>
    <message>
        <source>Quick render, &amp;ambient occlusion:</source>
        <translation>Rychlé vykreslení, z&amp;astínění okolím:</translation>
    </message>
    <message>
        <source>Quick render, occlusion &amp;rays:</source>
        <translation>Rychlé vykreslení, &amp;paprsky zastínění:</translation>
    </message>
    <message>
        <source>usual on desktops</source>
        <translation>obvyklé na ploše</translation>
    </message>
    <message>
        <source>Classic shortcuts</source>
        <translation>Klasické zkratky</translation>
    </message>
    <message>
        <source>Of the menus: Ctrl+S saves and Ctrl+C copies the camera, or they start a server and connect to one</source>
        <translation>V nabídkách: Ctrl+S ukládá a Ctrl+C kopíruje kameru, nebo spouštějí server a připojují se k němu</translation>
    </message>
    <message>
        <source>&amp;Shortcuts:</source>
        <translation>Zk&amp;ratky:</translation>
    </message>
    <message>
        <source>Global illumination, sam&amp;ples:</source>
        <translation>&amp;Globální osvětlení, vzorků:</translation>
    </message>
    <message>
        <source>The language holds from the next start of the window.</source>
        <translation>Jazyk platí od příštího spuštění okna.</translation>
    </message>
    <message>
        <source>While a drag turns the model (View &gt; Orbit)</source>
        <translation>Když tažení otáčí model (Pohled &gt; Otáčet model)</translation>
    </message>
    <message>
        <source>&amp;Drags:</source>
        <translation>&amp;Tažení:</translation>
    </message>
    <message>
        <source>Image at &amp;rest:</source>
        <translation>Obraz v klid&amp;u:</translation>
    </message>
    <message>
        <source>Passes of the &amp;filter:</source>
        <translation>Průchody &amp;filtru:</translation>
    </message>
    <message>
        <source>by a net; by the filter where its weights are missing</source>
        <translation>sítí; filtrem tam, kde chybějí její váhy</translation>
    </message>
    <message>
        <source>by the filter</source>
        <translation>filtrem</translation>
    </message>
    <message>
        <source>Global illumination, &amp;denoise:</source>
        <translation>Globální osvětlení, odstra&amp;nění šumu:</translation>
    </message>
</context>
<context>
    <name>gui::ConnectDialog</name>
    <message>
        <source>loading</source>
        <translation>načítá</translation>
    </message>
    <message>
        <source>does not suit</source>
        <translation>nevyhovuje</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Připojit</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Název</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Proces</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Obraz</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Trojúhelníky</translation>
    </message>
    <message>
        <source>Clients</source>
        <translation>Klienti</translation>
    </message>
    <message>
        <source>Servers</source>
        <translation>Servery</translation>
    </message>
    <message>
        <source>&amp;Servers that run on this machine:</source>
        <translation>&amp;Servery, které na tomto počítači běží:</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Připojit</translation>
    </message>
    <message>
        <source>There is none. “Start new server” starts one.</source>
        <translation>Žádný neběží. Spustíte ho volbou „Spustit nový server“.</translation>
    </message>
</context>
<context>
    <name>gui::ConnectionOperations</name>
    <message>
        <source>Open a scene or a model</source>
        <translation>Otevřít scénu nebo model</translation>
    </message>
    <message>
        <source>Open a scene first.</source>
        <translation>Nejprve otevřete scénu.</translation>
    </message>
    <message>
        <source>Loading %1…</source>
        <translation>Načítá se %1…</translation>
    </message>
    <message>
        <source>The file “%1” cannot be read.</source>
        <translation>Soubor „%1“ nelze přečíst.</translation>
    </message>
    <message>
        <source>The server “%1” answered after %2 ms.</source>
        <translation>Server „%1“ odpověděl za %2 ms.</translation>
    </message>
    <message>
        <source>Stop server</source>
        <translation>Zastavit server</translation>
    </message>
    <message>
        <source>End the server “%1”? All windows connected to it lose it.</source>
        <translation>Ukončit server „%1“? Přijdou o něj všichni, kdo jej sledují.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Zastavit</translation>
    </message>
</context>
<context>
    <name>gui::CornerPlan</name>
    <message>
        <source>Show the storey below</source>
        <translation>Ukázat podlaží níže</translation>
    </message>
    <message>
        <source>Show the storey above</source>
        <translation>Ukázat podlaží výše</translation>
    </message>
    <message>
        <source>Plan in the corner</source>
        <translation>Plán v rohu</translation>
    </message>
    <message>
        <source>A click goes there, a drag looks there</source>
        <translation>Kliknutí tam přejde, tažení tam otočí pohled</translation>
    </message>
    <message>
        <source>Nothing is cut there.</source>
        <translation>Řez tam nic neprotíná.</translation>
    </message>
    <message>
        <source>Storey %1 of %2</source>
        <translation>Podlaží %1 z %2</translation>
    </message>
    <message>
        <source>No storeys: contour lines</source>
        <translation>Bez podlaží: vrstevnice</translation>
    </message>
</context>
<context>
    <name>gui::CornerPlanOperations</name>
    <message>
        <source>The plan is being made…</source>
        <translation>Plán se připravuje…</translation>
    </message>
    <message>
        <source>The plan cannot be read.</source>
        <translation>Plán nelze přečíst.</translation>
    </message>
    <message>
        <source>This model has no storeys.</source>
        <translation>Tento model nemá podlaží.</translation>
    </message>
    <message>
        <source>This is the lowest storey.</source>
        <translation>Toto je nejnižší podlaží.</translation>
    </message>
    <message>
        <source>This is the highest storey.</source>
        <translation>Toto je nejvyšší podlaží.</translation>
    </message>
    <message>
        <source>Storey %1 of %2</source>
        <translation>Podlaží %1 z %2</translation>
    </message>
</context>
<context>
    <name>gui::DisplayOperations</name>
    <message>
        <source>live</source>
        <translation>živý</translation>
    </message>
</context>
<context>
    <name>gui::ExportCameraDialog</name>
    <message>
        <source>Path</source>
        <translation>Cesta</translation>
    </message>
    <message>
        <source>Cameras (*.cam);;All files (*)</source>
        <translation>Kamery (*.cam);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Export camera</source>
        <translation>Exportovat kameru</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Šířka</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Anti-aliasing</source>
        <translation>Vyhlazování hran</translation>
    </message>
    <message>
        <source>N × N samples per pixel</source>
        <translation>N × N vzorků na bod</translation>
    </message>
    <message>
        <source>Bloom</source>
        <translation>Záře</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádná</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> bodů</translation>
    </message>
    <message>
        <source>As &amp;now</source>
        <translation>Jako &amp;nyní</translation>
    </message>
    <message>
        <source>The size that the server draws now</source>
        <translation>Velikost, kterou server kreslí nyní</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportovat</translation>
    </message>
    <message>
        <source>&amp;Path:</source>
        <translation>&amp;Cesta:</translation>
    </message>
    <message>
        <source>&amp;Resolution:</source>
        <translation>&amp;Rozlišení:</translation>
    </message>
    <message>
        <source>&amp;Anti-aliasing:</source>
        <translation>&amp;Vyhlazování hran:</translation>
    </message>
    <message>
        <source>&amp;Bloom:</source>
        <translation>&amp;Záře:</translation>
    </message>
</context>
<context>
    <name>gui::FieldOfViewDialog</name>
    <message>
        <source>%1° (%2 mm)</source>
        <translation>%1° (%2 mm)</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Úhel</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Ohnisková vzdálenost</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Úhel záběru</translation>
    </message>
    <message>
        <source>From the left to the right edge of the image. Eyes that look ahead: about 60°</source>
        <translation>Od levého k pravému okraji obrazu. Oči, které hledí vpřed: asi 60°</translation>
    </message>
    <message>
        <source>Of a camera for film of 36 × 24 mm: 18 mm is wide, 50 mm usual, 85 mm for portraits</source>
        <translation>Fotoaparátu na film 36 × 24 mm: 18 mm je široký, 50 mm běžný, 85 mm na portréty</translation>
    </message>
    <message>
        <source>&amp;Angle:</source>
        <translation>Ú&amp;hel:</translation>
    </message>
    <message>
        <source>&amp;Focal length:</source>
        <translation>&amp;Ohnisková vzdálenost:</translation>
    </message>
</context>
<context>
    <name>gui::FileField</name>
    <message>
        <source>Browse…</source>
        <translation>Procházet…</translation>
    </message>
    <message>
        <source>Browse: %1</source>
        <translation>Procházet: %1</translation>
    </message>
</context>
<context>
    <name>gui::FlightKeys</name>
    <message>
        <source>Key frames</source>
        <translation>Klíčové snímky</translation>
    </message>
    <message>
        <source>Enter or a double click looks from there</source>
        <translation>Enter nebo dvojité kliknutí se odtud podívá</translation>
    </message>
    <message>
        <source>Time of the key frame</source>
        <translation>Čas klíčového snímku</translation>
    </message>
    <message>
        <source>When the flight comes through the selected key frame; of a flight whose key frames have times</source>
        <translation>Kdy let prochází vybraným klíčovým snímkem; u letu, jehož klíčové snímky mají časy</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>At:</source>
        <translation>V čase:</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Přidat</translation>
    </message>
    <message>
        <source>Let the flight end at the current view</source>
        <translation>Ukončit let nynějším pohledem</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Nahradit</translation>
    </message>
    <message>
        <source>Let the selected key frame be the current view</source>
        <translation>Dát vybranému klíčovému snímku nynější pohled</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Dříve</translation>
    </message>
    <message>
        <source>Move the selected key frame before the one above it</source>
        <translation>Přesunout vybraný klíčový snímek před ten nad ním</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Později</translation>
    </message>
    <message>
        <source>Move the selected key frame behind the one below it</source>
        <translation>Přesunout vybraný klíčový snímek za ten pod ním</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odebrat</translation>
    </message>
    <message>
        <source>Remove the selected key frame; also Del. The last one goes with its flight</source>
        <translation>Odebrat vybraný klíčový snímek; též Del. S posledním zmizí i let</translation>
    </message>
    <message>
        <source>%1: at %2 s</source>
        <translation>%1: v čase %2 s</translation>
    </message>
</context>
<context>
    <name>gui::FlightOperations</name>
    <message>
        <source>Flights</source>
        <translation>Lety</translation>
    </message>
    <message>
        <source>Key frame %1 of %2</source>
        <translation>Klíčový snímek %1, %2</translation>
    </message>
</context>
<context>
    <name>gui::FlightPlayer</name>
    <message>
        <source>Time</source>
        <translation>Čas</translation>
    </message>
    <message>
        <source>Look from where the flight is at that time</source>
        <translation>Podívat se odtud, kde let v té chvíli je</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zastavit</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Přehrát</translation>
    </message>
    <message>
        <source>Stay where the flight is now</source>
        <translation>Zůstat tam, kde let právě je</translation>
    </message>
    <message>
        <source>Show the flight in real time from here on; moving ends it</source>
        <translation>Ukázat let odtud dál v reálném čase; pohyb ho ukončí</translation>
    </message>
</context>
<context>
    <name>gui::FlightsPanel</name>
    <message>
        <source>Seconds:</source>
        <translation>Sekundy:</translation>
    </message>
    <message>
        <source>Speed:</source>
        <translation>Rychlost:</translation>
    </message>
    <message>
        <source>Flight</source>
        <translation>Let</translation>
    </message>
    <message>
        <source>Key frames</source>
        <translation>Klíčové snímky</translation>
    </message>
    <message>
        <source>Flights</source>
        <translation>Lety</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Název</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekundy</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nový</translation>
    </message>
    <message>
        <source>Begin a flight at the current view; add key frames from other views</source>
        <translation>Začít let v nynějším pohledu; z dalších pohledů přidat klíčové snímky</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Otočný stůl</translation>
    </message>
    <message>
        <source>Once around what one orbits in 10 seconds</source>
        <translation>Jednou dokola kolem středu otáčení za 10 sekund</translation>
    </message>
    <message>
        <source>Through the saved views</source>
        <translation>Uloženými pohledy</translation>
    </message>
    <message>
        <source>Through all bookmarks of the scene, in their order, in 10 seconds</source>
        <translation>Všemi záložkami scény v jejich pořadí za 10 sekund</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odebrat</translation>
    </message>
    <message>
        <source>Remove the selected flight; also Del. Can be undone</source>
        <translation>Odebrat vybraný let; též Del. Lze vrátit</translation>
    </message>
    <message>
        <source>Film…</source>
        <translation>Film…</translation>
    </message>
    <message>
        <source>Render the selected flight as a film or images</source>
        <translation>Vykreslit vybraný let jako film nebo obrázky</translation>
    </message>
    <message>
        <source>Flight %1</source>
        <translation>Let %1</translation>
    </message>
    <message>
        <source>Turntable %1</source>
        <translation>Otočný stůl %1</translation>
    </message>
    <message>
        <source>Views %1</source>
        <translation>Pohledy %1</translation>
    </message>
    <message>
        <source>How long the whole takes; times of key frames are stretched</source>
        <translation>Jak dlouho trvá celý let; časy klíčových snímků se roztáhnou</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Rychlost</translation>
    </message>
    <message>
        <source>even</source>
        <translation>stálá</translation>
    </message>
    <message>
        <source>by the times of key frames</source>
        <translation>podle časů klíčových snímků</translation>
    </message>
    <message>
        <source>One speed all the way, or through each key frame at its time</source>
        <translation>Po celé dráze stejná rychlost, nebo každým klíčovým snímkem v jeho čase</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Uzavřený</translation>
    </message>
    <message>
        <source>Go on from the last key frame to the first; at an even speed</source>
        <translation>Pokračovat od posledního klíčového snímku k prvnímu; při stálé rychlosti</translation>
    </message>
    <message>
        <source>turntable</source>
        <translation>otočný stůl</translation>
    </message>
</context>
<context>
    <name>gui::FoldBox</name>
    <message>
        <source>Some of these differ from their defaults</source>
        <translation>Něco z toho se liší od výchozího nastavení</translation>
    </message>
</context>
<context>
    <name>gui::FrameView</name>
    <message>
        <source>Image</source>
        <translation>Obraz</translation>
    </message>
    <message>
        <source>The viewport. Keys move; Enter or a click captures mouse and keyboard, Esc releases them.</source>
        <translation>Živý obraz. Klávesami se pohybujete; Enter nebo kliknutí zachytí myš a klávesnici, Esc je uvolní.</translation>
    </message>
    <message>
        <source>Mouse and keyboard captured. Esc releases them.</source>
        <translation>Myš a klávesnice jsou zachyceny. Esc je uvolní.</translation>
    </message>
</context>
<context>
    <name>gui::JobDialog</name>
    <message>
        <source>Command</source>
        <translation>Příkaz</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>Kopí&amp;rovat</translation>
    </message>
    <message>
        <source>Copy the command, for a terminal or a script</source>
        <translation>Kopírovat příkaz pro terminál nebo skript</translation>
    </message>
    <message>
        <source>&amp;More options</source>
        <translation>&amp;Další volby</translation>
    </message>
    <message>
        <source>Comman&amp;d:</source>
        <translation>&amp;Příkaz:</translation>
    </message>
</context>
<context>
    <name>gui::JobOperations</name>
    <message>
        <source>Jobs</source>
        <translation>Úlohy</translation>
    </message>
    <message>
        <source>%1: done.</source>
        <translation>%1: hotovo.</translation>
    </message>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1 selhala: %2</translation>
    </message>
    <message>
        <source>There is no program that shows %1.</source>
        <translation>Žádný program neumí zobrazit %1.</translation>
    </message>
    <message>
        <source>Jobs are not finished</source>
        <translation>Úlohy nejsou dokončeny</translation>
    </message>
    <message numerus="yes">
        <source>Unfinished jobs: %n. Stop and close?</source>
        <translation>
            <numerusform>%n úloha běží nebo čeká. Zastavit ji a zavřít okno?</numerusform>
            <numerusform>%n úlohy běží nebo čekají. Zastavit je a zavřít okno?</numerusform>
            <numerusform>%n úloh běží nebo čeká. Zastavit je a zavřít okno?</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Stop and close</source>
        <translation>&amp;Zastavit a zavřít</translation>
    </message>
    <message>
        <source>&amp;Keep running</source>
        <translation>&amp;Nechat běžet</translation>
    </message>
</context>
<context>
    <name>gui::JobProcess</name>
    <message>
        <source>The program was killed or has crashed (signal %1).</source>
        <translation>Program byl násilně ukončen nebo havaroval (signál %1).</translation>
    </message>
    <message>
        <source>The program %1 was found neither beside this one nor in PATH.</source>
        <translation>Program %1 nebyl nalezen vedle tohoto programu ani v PATH.</translation>
    </message>
</context>
<context>
    <name>gui::JobQueue</name>
    <message>
        <source>It ended with exit code %1.</source>
        <translation>Skončila s návratovým kódem %1.</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>čeká</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%1 %2 z %3</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>spouští se</translation>
    </message>
    <message>
        <source>stopping</source>
        <translation>zastavuje se</translation>
    </message>
    <message>
        <source>done</source>
        <translation>hotovo</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>selhala</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>zrušena</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Úloha</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stav</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Průběh</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Zbývá</translation>
    </message>
</context>
<context>
    <name>gui::JobsPanel</name>
    <message>
        <source>Result</source>
        <translation>Výsledek</translation>
    </message>
    <message>
        <source>Log of the job</source>
        <translation>Výpis úlohy</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Úlohy</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zobrazit</translation>
    </message>
    <message>
        <source>Show the result</source>
        <translation>Zobrazit výsledek</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Otevřít složku</translation>
    </message>
    <message>
        <source>Open the folder of the result</source>
        <translation>Otevřít složku s výsledkem</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nahoru</translation>
    </message>
    <message>
        <source>Let the job run earlier</source>
        <translation>Spustit úlohu dříve</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Dolů</translation>
    </message>
    <message>
        <source>Let the job run later</source>
        <translation>Spustit úlohu později</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
    <message>
        <source>Stop the job, or take it out of the queue</source>
        <translation>Zastavit úlohu nebo ji vyřadit z fronty</translation>
    </message>
    <message>
        <source>Run again</source>
        <translation>Spustit znovu</translation>
    </message>
    <message>
        <source>Put the job at the end of the queue once more</source>
        <translation>Zařadit úlohu znovu na konec fronty</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odebrat</translation>
    </message>
    <message>
        <source>Remove the job from the list; its result stays</source>
        <translation>Odebrat úlohu ze seznamu; výsledek zůstane</translation>
    </message>
    <message>
        <source>Remove finished</source>
        <translation>Odebrat dokončené</translation>
    </message>
    <message>
        <source>Remove all jobs that are over from the list</source>
        <translation>Odebrat ze seznamu všechny skončené úlohy</translation>
    </message>
    <message>
        <source>Kill</source>
        <translation>Ukončit násilím</translation>
    </message>
    <message>
        <source>There are no jobs. Render &gt; Render… makes one.</source>
        <translation>Nejsou žádné úlohy. Vykreslit &gt; Vykreslit do souboru… nějakou přidá.</translation>
    </message>
</context>
<context>
    <name>gui::KeyBindingsPage</name>
    <message>
        <source>Action</source>
        <translation>Akce</translation>
    </message>
    <message>
        <source>Number of the light or environment map</source>
        <translation>Číslo světla nebo mapy prostředí</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Klávesy</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Číslo</translation>
    </message>
    <message>
        <source>Key bindings</source>
        <translation>Přiřazení kláves</translation>
    </message>
    <message>
        <source>A key is written by its name: W, 7, Space, Left, CapsLock. M+3 acts when 3 is pressed while M is down.</source>
        <translation>Klávesa se zapisuje jménem: W, 7, Space, Left, CapsLock. M+3 platí, když se při držené M stiskne 3.</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Přidat</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>O&amp;debrat</translation>
    </message>
    <message>
        <source>&amp;Defaults</source>
        <translation>&amp;Výchozí</translation>
    </message>
    <message>
        <source>“%1” is no key.</source>
        <translation>„%1“ není klávesa.</translation>
    </message>
    <message>
        <source>%1 stands twice.</source>
        <translation>%1 je uvedena dvakrát.</translation>
    </message>
</context>
<context>
    <name>gui::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>Klávesy</translation>
    </message>
</context>
<context>
    <name>gui::LightFields</name>
    <message>
        <source>Light %1</source>
        <translation>Světlo %1</translation>
    </message>
    <message>
        <source>Name of the light</source>
        <translation>Název světla</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Název</translation>
    </message>
    <message>
        <source>Kind of the light</source>
        <translation>Druh světla</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Druh</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Poloha</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Sem</translation>
    </message>
    <message>
        <source>Put the light at the camera</source>
        <translation>Umístit světlo ke kameře</translation>
    </message>
    <message>
        <source>At view centre</source>
        <translation>Do středu pohledu</translation>
    </message>
    <message>
        <source>Put it before the surface in the middle of the image</source>
        <translation>Umístit je před povrch uprostřed obrazu</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Směr</translation>
    </message>
    <message>
        <source>Along view</source>
        <translation>Ve směru pohledu</translation>
    </message>
    <message>
        <source>Let it shine as the camera looks</source>
        <translation>Ať svítí, kam se dívá kamera</translation>
    </message>
    <message>
        <source>Aim at view centre</source>
        <translation>Zamířit na střed pohledu</translation>
    </message>
    <message>
        <source>Let it shine to what is in the middle of the image</source>
        <translation>Ať svítí na to, co je uprostřed obrazu</translation>
    </message>
    <message>
        <source>Colour of the light</source>
        <translation>Barva světla</translation>
    </message>
    <message>
        <source>Choose a colour; the power stays</source>
        <translation>Zvolit barvu; výkon zůstane</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Barva</translation>
    </message>
    <message>
        <source>Colour by temperature</source>
        <translation>Barva podle teploty</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Teplota</translation>
    </message>
    <message>
        <source>Of a black body: candle 1900 K, bulb 2700 K, sun 5800 K</source>
        <translation>Černého tělesa: svíčka 1900 K, žárovka 2700 K, slunce 5800 K</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Výkon</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Angle of full brightness</source>
        <translation>Úhel plného jasu</translation>
    </message>
    <message>
        <source>Angle where it ends</source>
        <translation>Úhel, kde světlo končí</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Velikost</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Úhly</translation>
    </message>
    <message>
        <source>Angle under which it is seen</source>
        <translation>Úhel, pod kterým je vidět</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Šířka</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Poloměr</translation>
    </message>
    <message>
        <source>The sun has 0.53°; 0: shadows are sharp</source>
        <translation>Slunce má 0,53°; 0: stíny jsou ostré</translation>
    </message>
    <message>
        <source>Seen in mirrors</source>
        <translation>Vidět v zrcadlech</translation>
    </message>
    <message>
        <source>Mirrors, lacquer and glass that bends show the light itself; the camera does not</source>
        <translation>Zrcadla, lak a sklo, které láme světlo, ukazují samotné světlo; kamera ne</translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation>Otočit doleva</translation>
    </message>
    <message>
        <source>Turn it by 15° about its direction</source>
        <translation>Otočí je o 15° kolem jeho směru</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>Otočit doprava</translation>
    </message>
    <message>
        <source>File of the light</source>
        <translation>Soubor světla</translation>
    </message>
    <message>
        <source>An IES or EULUMDAT file, which says how the luminaire shines</source>
        <translation>Soubor IES nebo EULUMDAT, který říká, jak svítidlo svítí</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Soubor</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Vybrat…</translation>
    </message>
    <message>
        <source>Open a luminaire</source>
        <translation>Otevřít svítidlo</translation>
    </message>
    <message>
        <source>Luminaires (*.ies *.ldt);;All files (*)</source>
        <translation>Svítidla (*.ies *.ldt);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>of the model</source>
        <translation>z modelu</translation>
    </message>
</context>
<context>
    <name>gui::LightOperations</name>
    <message>
        <source>Lights</source>
        <translation>Světla</translation>
    </message>
</context>
<context>
    <name>gui::LightsPanel</name>
    <message>
        <source>Lights</source>
        <translation>Světla</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Mapa %1</translation>
    </message>
    <message>
        <source>Key: %1</source>
        <translation>Klávesa: %1</translation>
    </message>
    <message>
        <source>Keys: M and %1</source>
        <translation>Klávesy: M a %1</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopírovat</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odebrat</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Přidat</translation>
    </message>
    <message>
        <source>Add a light where you look</source>
        <translation>Přidat světlo tam, kam se díváte</translation>
    </message>
    <message>
        <source>Add a light like the selected one, in its place</source>
        <translation>Přidat stejné světlo, jako je vybrané, na jeho místo</translation>
    </message>
    <message>
        <source>Remove the selected light</source>
        <translation>Odebrat vybrané světlo</translation>
    </message>
    <message>
        <source>Show lights</source>
        <translation>Zobrazit světla</translation>
    </message>
    <message>
        <source>Surroundings</source>
        <translation>Okolí</translation>
    </message>
    <message>
        <source>Environment map…</source>
        <translation>Mapa prostředí…</translation>
    </message>
    <message>
        <source>Computed sky with a sun</source>
        <translation>Počítaná obloha se sluncem</translation>
    </message>
    <message>
        <source>No background</source>
        <translation>Žádné pozadí</translation>
    </message>
</context>
<context>
    <name>gui::LogDialog</name>
    <message>
        <source>Server log</source>
        <translation>Výpis serveru</translation>
    </message>
    <message>
        <source>Nothing yet.</source>
        <translation>Zatím nic.</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Výpis</translation>
    </message>
    <message>
        <source>Co&amp;py all</source>
        <translation>&amp;Kopírovat vše</translation>
    </message>
</context>
<context>
    <name>gui::LookOperations</name>
    <message>
        <source>Field of view %1</source>
        <translation>Úhel záběru %1</translation>
    </message>
</context>
<context>
    <name>gui::MainWindow</name>
    <message>
        <source>rtsuite</source>
        <translation>rtsuite</translation>
    </message>
</context>
<context>
    <name>gui::MaterialFields</name>
    <message>
        <source>Colour</source>
        <translation>Barva</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Drsnost</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Kov</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Zrcadlo</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Neprůhlednost</translation>
    </message>
    <message>
        <source>Glass colour</source>
        <translation>Barva skla</translation>
    </message>
    <message>
        <source>Refraction</source>
        <translation>Index lomu</translation>
    </message>
    <message>
        <source>Reset this material</source>
        <translation>Vrátit tento materiál</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Textury</translation>
    </message>
    <message>
        <source>Upside down</source>
        <translation>Vzhůru nohama</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Jako v souboru</translation>
    </message>
    <message>
        <source>Varnish</source>
        <translation>Lak</translation>
    </message>
    <message>
        <source>Its roughness</source>
        <translation>Drsnost laku</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Priorita</translation>
    </message>
</context>
<context>
    <name>gui::MeasureOperations</name>
    <message>
        <source>Measures</source>
        <translation>Míry</translation>
    </message>
    <message>
        <source>Nothing of the model is seen there.</source>
        <translation>Na tom místě není z modelu nic vidět.</translation>
    </message>
    <message>
        <source>Click points one after another. Shift keeps to an axis.</source>
        <translation>Klikejte na body jeden po druhém. Shift drží osu.</translation>
    </message>
    <message>
        <source>Enter or a double click keeps the chain.</source>
        <translation>Enter nebo dvojklik řetězec uchová.</translation>
    </message>
    <message>
        <source>Click the point that the angle is at.</source>
        <translation>Klikněte na vrchol úhlu.</translation>
    </message>
    <message>
        <source>Click three points, the second at the angle.</source>
        <translation>Klikněte na tři body, druhý je vrchol úhlu.</translation>
    </message>
    <message>
        <source>Click a point above the floor.</source>
        <translation>Klikněte na bod nad podlahou.</translation>
    </message>
    <message>
        <source>Click a face.</source>
        <translation>Klikněte na plochu.</translation>
    </message>
    <message>
        <source>Click a closed part.</source>
        <translation>Klikněte na uzavřenou část.</translation>
    </message>
    <message>
        <source>Click two points. Shift keeps to an axis, Esc ends.</source>
        <translation>Klikněte na dva body. Shift drží osu, Esc končí.</translation>
    </message>
    <message>
        <source>Export the measures</source>
        <translation>Exportovat míry</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabulky (*.csv)</translation>
    </message>
    <message>
        <source>The measures were written to %1.</source>
        <translation>Míry byly zapsány do %1.</translation>
    </message>
</context>
<context>
    <name>gui::MeasuresPanel</name>
    <message>
        <source>Measure</source>
        <translation>Měření</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Míry</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Popisky</translation>
    </message>
    <message>
        <source>Between two points</source>
        <translation>Mezi dvěma body</translation>
    </message>
    <message>
        <source>Along three points or more; Enter ends it</source>
        <translation>Přes tři body nebo více; Enter končí</translation>
    </message>
    <message>
        <source>At the second of three points</source>
        <translation>U druhého ze tří bodů</translation>
    </message>
    <message>
        <source>Of a point above the floor</source>
        <translation>Bodu nad podlahou</translation>
    </message>
    <message>
        <source>Of a face, with all that is in its plane</source>
        <translation>Plochy i se vším, co leží v její rovině</translation>
    </message>
    <message>
        <source>Of a closed part</source>
        <translation>Uzavřené části</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Název</translation>
    </message>
    <message>
        <source>Stands in the label of the selected measure</source>
        <translation>Stojí v popisku vybrané míry</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Přejít tam</translation>
    </message>
    <message>
        <source>Look at the selected measure; also Enter or a double click</source>
        <translation>Podívat se na vybranou míru; také Enter nebo dvojklik</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odebrat</translation>
    </message>
    <message>
        <source>Remove the selected measure; also Del</source>
        <translation>Odebrat vybranou míru; také Del</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Odebrat vše</translation>
    </message>
    <message>
        <source>Can be undone</source>
        <translation>Lze vrátit</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportovat…</translation>
    </message>
    <message>
        <source>Write all measures as a table, a .csv file</source>
        <translation>Zapsat všechny míry jako tabulku do souboru .csv</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednotka</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>Desetinná místa</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>a %n další</numerusform>
            <numerusform>a %n další</numerusform>
            <numerusform>a %n dalších</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gui::MessageOperations</name>
    <message>
        <source>%1 is up</source>
        <translation>Vzhůru je %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zpět</translation>
    </message>
    <message>
        <source>Switch Them Off</source>
        <translation>Zhasnout je</translation>
    </message>
</context>
<context>
    <name>gui::ModeOperations</name>
    <message>
        <source>A click takes the mouse, which looks around; Esc gives it back.</source>
        <translation>Kliknutí převezme myš, která se rozhlíží; Esc ji vrátí.</translation>
    </message>
    <message>
        <source>Turn the model: %1; move it: %2; go nearer: %3</source>
        <translation>Otočit model: %1; posunout: %2; přiblížit: %3</translation>
    </message>
</context>
<context>
    <name>gui::ModelOperations</name>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Nothing of the model is seen there.</source>
        <translation>Na tom místě není z modelu nic vidět.</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>&amp;Skrýt</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>&amp;Osamostatnit</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Zobrazit &amp;vše</translation>
    </message>
    <message>
        <source>Edit the &amp;material</source>
        <translation>Upravit &amp;materiál</translation>
    </message>
    <message>
        <source>&amp;Go there</source>
        <translation>&amp;Jít tam</translation>
    </message>
    <message>
        <source>No part is selected: a right click on the image, or a row of the model panel, selects one.</source>
        <translation>Žádná část není vybrána: vybere ji pravé tlačítko v obraze nebo řádek panelu modelu.</translation>
    </message>
    <message>
        <source>Do &amp;not cut</source>
        <translation>&amp;Neřezat</translation>
    </message>
</context>
<context>
    <name>gui::ModelPanel</name>
    <message>
        <source>Without a name (%1)</source>
        <translation>Bez názvu (%1)</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Části</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materiály</translation>
    </message>
    <message>
        <source>%1: %2 triangles</source>
        <translation>%1, trojúhelníků: %2</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Změněno</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>&amp;Skrýt</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Zobrazit</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>&amp;Osamostatnit</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Zobrazit &amp;vše</translation>
    </message>
    <message>
        <source>Do &amp;not cut</source>
        <translation>&amp;Neřezat</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>Ř&amp;ezat</translation>
    </message>
    <message>
        <source>Copy material</source>
        <translation>Kopírovat materiál</translation>
    </message>
    <message>
        <source>Paste material</source>
        <translation>Vložit materiál</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Předvolba</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Vybrat vše</translation>
    </message>
    <message>
        <source>Select all parts and materials that are found (Return)</source>
        <translation>Vybrat všechny nalezené části a materiály (Enter)</translation>
    </message>
    <message>
        <source>Make it a ready-made material</source>
        <translation>Udělat z něj předvolený materiál</translation>
    </message>
    <message>
        <source>Keep which material is to be pasted</source>
        <translation>Zapamatovat, který materiál se má vložit</translation>
    </message>
    <message>
        <source>Make it look like %1</source>
        <translation>Dát mu vzhled materiálu %1</translation>
    </message>
    <message>
        <source>No material is copied</source>
        <translation>Žádný materiál není zkopírován</translation>
    </message>
</context>
<context>
    <name>gui::ModelSearch</name>
    <message>
        <source>Find by name, with * and ?</source>
        <translation>Hledat podle jména, i s * a ?</translation>
    </message>
    <message>
        <source>Find parts and materials</source>
        <translation>Hledat části a materiály</translation>
    </message>
</context>
<context>
    <name>gui::MotionOperations</name>
    <message>
        <source>Flying speed × %1</source>
        <translation>Rychlost letu × %1</translation>
    </message>
    <message>
        <source>Flying speed × %1; walking keeps its own</source>
        <translation>Rychlost letu × %1; chůze má svou vlastní</translation>
    </message>
</context>
<context>
    <name>gui::NoteDialog</name>
    <message>
        <source>Add a note</source>
        <translation>Přidat poznámku</translation>
    </message>
    <message>
        <source>Edit the note</source>
        <translation>Upravit poznámku</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Žádný</translation>
    </message>
    <message>
        <source>Kept with the note, and as a preference; may be empty</source>
        <translation>Zůstane u poznámky a v předvolbách; může být prázdný</translation>
    </message>
    <message>
        <source>&amp;Text:</source>
        <translation>&amp;Text:</translation>
    </message>
    <message>
        <source>&amp;Author:</source>
        <translation>&amp;Autor:</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Uložit</translation>
    </message>
    <message>
        <source>A note has at most %1 characters.</source>
        <translation>Poznámka má nejvýše %1 znaků.</translation>
    </message>
</context>
<context>
    <name>gui::NoteOperations</name>
    <message>
        <source>Notes</source>
        <translation>Poznámky</translation>
    </message>
    <message>
        <source>Click the place that the note is about. Esc ends.</source>
        <translation>Klepněte na místo, kterého se poznámka týká. Esc končí.</translation>
    </message>
    <message>
        <source>Nothing of the model is seen there.</source>
        <translation>Tam není z modelu nic vidět.</translation>
    </message>
    <message>
        <source>Export the notes</source>
        <translation>Exportovat poznámky</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabulky (*.csv)</translation>
    </message>
    <message>
        <source>The notes were written to %1.</source>
        <translation>Poznámky byly zapsány do %1.</translation>
    </message>
    <message>
        <source>This note was changed or removed meanwhile.</source>
        <translation>Tato poznámka byla mezitím změněna nebo odstraněna.</translation>
    </message>
    <message>
        <source>The text of the note is kept for the next one.</source>
        <translation>Text poznámky je uschován pro příští.</translation>
    </message>
</context>
<context>
    <name>gui::NotesPanel</name>
    <message>
        <source>Notes</source>
        <translation>Poznámky</translation>
    </message>
    <message>
        <source>Add a note</source>
        <translation>Přidat poznámku</translation>
    </message>
    <message>
        <source>Click the place in the image that the note is about</source>
        <translation>Klepněte v obraze na místo, kterého se poznámka týká</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Přejít tam</translation>
    </message>
    <message>
        <source>Look from where the note was written; also Enter or a double click</source>
        <translation>Pohled z místa, kde byla poznámka napsána; též Enter nebo dvojité klepnutí</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Upravit…</translation>
    </message>
    <message>
        <source>Change the text or the author of the selected note</source>
        <translation>Změnit text nebo autora vybrané poznámky</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odebrat</translation>
    </message>
    <message>
        <source>Remove the selected note; also Del</source>
        <translation>Odebrat vybranou poznámku; též Del</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportovat…</translation>
    </message>
    <message>
        <source>Write all notes as a table, a .csv file</source>
        <translation>Zapsat všechny poznámky jako tabulku, soubor .csv</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>a %n další</numerusform>
            <numerusform>a %n další</numerusform>
            <numerusform>a %n dalších</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gui::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation>Oznámení</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zavřít</translation>
    </message>
</context>
<context>
    <name>gui::OptionFields</name>
    <message>
        <source>All files (*)</source>
        <translation>Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Usual files (%1)</source>
        <translation>Obvyklé soubory (%1)</translation>
    </message>
    <message>
        <source>default</source>
        <translation>výchozí</translation>
    </message>
    <message>
        <source>default (%1)</source>
        <translation>výchozí (%1)</translation>
    </message>
</context>
<context>
    <name>gui::PanelOperations</name>
    <message>
        <source>Settings</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Vráceno: %1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>Provedeno znovu: %1</translation>
    </message>
    <message>
        <source>Image at rest</source>
        <translation>Obraz v klidu</translation>
    </message>
    <message>
        <source>What is shown when the camera rests</source>
        <translation>Co se ukazuje, když kamera stojí</translation>
    </message>
    <message>
        <source>Image at rest:</source>
        <translation>Obraz v klidu:</translation>
    </message>
</context>
<context>
    <name>gui::PictureDialog</name>
    <message>
        <source>Image %1</source>
        <translation>Obraz %1</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Přizpůsobit</translation>
    </message>
    <message>
        <source>All of the image</source>
        <translation>Celý obraz</translation>
    </message>
    <message>
        <source>1:1</source>
        <translation>1:1</translation>
    </message>
    <message>
        <source>A pixel for a pixel</source>
        <translation>Bod na bod</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Zmenšit</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Zvětšit</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopírovat</translation>
    </message>
    <message>
        <source>Copy the image</source>
        <translation>Kopírovat obraz</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Uložit jako…</translation>
    </message>
    <message>
        <source>Save a copy of the image</source>
        <translation>Uložit kopii obrazu</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Otevřít složku</translation>
    </message>
    <message>
        <source>Open the folder of the image</source>
        <translation>Otevřít složku s obrazem</translation>
    </message>
    <message>
        <source>%1 × %2, shown at %3 %</source>
        <translation>%1 × %2, ukázáno na %3 %</translation>
    </message>
    <message>
        <source>Save image</source>
        <translation>Uložit obraz</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.bmp *.ppm)</source>
        <translation>Obrazy (*.png *.jpg *.bmp *.ppm)</translation>
    </message>
    <message>
        <source>%1 was not written: %2</source>
        <translation>%1 nešlo zapsat: %2</translation>
    </message>
</context>
<context>
    <name>gui::PlanDialog</name>
    <message>
        <source>Plan</source>
        <translation>Plán</translation>
    </message>
    <message>
        <source>Height of the cut</source>
        <translation>Výška řezu</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Měřítko</translation>
    </message>
    <message>
        <source>From above: plan of a storey</source>
        <translation>Shora: půdorys podlaží</translation>
    </message>
    <message>
        <source>From the front: elevation</source>
        <translation>Zepředu: pohled</translation>
    </message>
    <message>
        <source>From the back: elevation</source>
        <translation>Zezadu: pohled</translation>
    </message>
    <message>
        <source>From the left: elevation</source>
        <translation>Zleva: pohled</translation>
    </message>
    <message>
        <source>From the right: elevation</source>
        <translation>Zprava: pohled</translation>
    </message>
    <message>
        <source>Section of the scene</source>
        <translation>Řez scény</translation>
    </message>
    <message>
        <source>Of a camera indoors, else the lowest</source>
        <translation>To, v němž je kamera uvnitř, jinak nejnižší</translation>
    </message>
    <message>
        <source>One sheet, as large as needed</source>
        <translation>Jeden list, tak velký, jak je třeba</translation>
    </message>
    <message>
        <source> m above the floor</source>
        <translation> m nad podlahou</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Nakreslit</translation>
    </message>
    <message>
        <source>&amp;Path:</source>
        <translation>&amp;Cesta:</translation>
    </message>
    <message>
        <source>&amp;View:</source>
        <translation>&amp;Pohled:</translation>
    </message>
    <message>
        <source>&amp;Storey:</source>
        <translation>P&amp;odlaží:</translation>
    </message>
    <message>
        <source>&amp;Cut:</source>
        <translation>Ř&amp;ez:</translation>
    </message>
    <message>
        <source>Sca&amp;le:</source>
        <translation>&amp;Měřítko:</translation>
    </message>
    <message>
        <source>P&amp;aper:</source>
        <translation>P&amp;apír:</translation>
    </message>
    <message>
        <source>%1: floor at %2 m</source>
        <translation>%1: podlaha ve výšce %2 m</translation>
    </message>
    <message>
        <source>Drawings (*.pdf *.svg *.dxf *.png *.tif);;All files (*)</source>
        <translation>Výkresy (*.pdf *.svg *.dxf *.png *.tif);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Rozlišení</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Čáry</translation>
    </message>
    <message>
        <source>Rendered light</source>
        <translation>Vykreslené světlo</translation>
    </message>
    <message>
        <source>Lines over light</source>
        <translation>Čáry přes světlo</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>&amp;Resolution:</source>
        <translation>&amp;Rozlišení:</translation>
    </message>
    <message>
        <source>&amp;Image:</source>
        <translation>O&amp;brázek:</translation>
    </message>
</context>
<context>
    <name>gui::PlanOperations</name>
    <message>
        <source>Drawing the plan…</source>
        <translation>Plán se kreslí…</translation>
    </message>
    <message>
        <source>The plan was written to %1.</source>
        <translation>Plán byl zapsán do %1.</translation>
    </message>
</context>
<context>
    <name>gui::PowerField</name>
    <message>
        <source>Power</source>
        <translation>Výkon</translation>
    </message>
    <message>
        <source>Unit of the power</source>
        <translation>Jednotka výkonu</translation>
    </message>
    <message>
        <source>Lumens, or radiant watts of 683 lumens each</source>
        <translation>Lumeny, nebo zářivé watty po 683 lumenech</translation>
    </message>
</context>
<context>
    <name>gui::PreviewProcess</name>
    <message>
        <source>The program Renderer was found neither beside this one nor in PATH.</source>
        <translation>Program Renderer nebyl nalezen vedle tohoto programu ani v PATH.</translation>
    </message>
    <message>
        <source>The Renderer failed.</source>
        <translation>Renderer selhal.</translation>
    </message>
</context>
<context>
    <name>gui::QrDialog</name>
    <message>
        <source>QR code: %1</source>
        <translation>QR kód: %1</translation>
    </message>
    <message>
        <source>The camera of a phone or a tablet opens the page by it.</source>
        <translation>Stránku pomocí něj otevře fotoaparát telefonu nebo tabletu.</translation>
    </message>
</context>
<context>
    <name>gui::QualityBar</name>
    <message>
        <source>Custom</source>
        <translation>Vlastní</translation>
    </message>
    <message>
        <source>Quality: %1</source>
        <translation>Kvalita: %1</translation>
    </message>
    <message>
        <source>The settings below are as in none of the three</source>
        <translation>Nastavení níže neodpovídají žádné z těch tří</translation>
    </message>
</context>
<context>
    <name>gui::RecordingDialog</name>
    <message>
        <source>List of cameras</source>
        <translation>Seznam kamer</translation>
    </message>
    <message>
        <source>Lists (*.lst *.txt);;All files (*)</source>
        <translation>Seznamy (*.lst *.txt);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Záznam</translation>
    </message>
    <message>
        <source>&amp;Path:</source>
        <translation>&amp;Cesta:</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Zastavit</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Začít</translation>
    </message>
    <message>
        <source>Recorded: %1</source>
        <translation>Zaznamenáno: %1</translation>
    </message>
    <message>
        <source>Render as &amp;film…</source>
        <translation>Vykreslit jako &amp;film…</translation>
    </message>
    <message>
        <source>From Start to Stop the camera, the exposure and the lights are written 30 times a second: .cam files and their list, which the Renderer makes a film of.</source>
        <translation>Mezi Začít a Zastavit se 30krát za sekundu zapisují kamera, expozice a světla: soubory .cam a jejich seznam, ze kterého Renderer udělá film.</translation>
    </message>
    <message>
        <source>P&amp;lay</source>
        <translation>Pře&amp;hrát</translation>
    </message>
    <message>
        <source>Recording %1 for %2 s.</source>
        <translation>Záznam %1 trvá %2 s.</translation>
    </message>
</context>
<context>
    <name>gui::RecordingMark</name>
    <message>
        <source>Recording, %1</source>
        <translation>Nahrávání, %1</translation>
    </message>
</context>
<context>
    <name>gui::RecordingOperations</name>
    <message>
        <source>The walk was recorded in %1.</source>
        <translation>Průchod byl nahrán do %1.</translation>
    </message>
</context>
<context>
    <name>gui::RenderDialog</name>
    <message>
        <source>Films (%1)</source>
        <translation>Filmy (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Images (%1)</source>
        <translation>Obrázky (%1)</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>Vykreslit</translation>
    </message>
    <message>
        <source>current view</source>
        <translation>aktuální pohled</translation>
    </message>
    <message>
        <source>a scene or a model</source>
        <translation>scéna nebo model</translation>
    </message>
    <message>
        <source>a recorded list of cameras</source>
        <translation>zaznamenaný seznam kamer</translation>
    </message>
    <message>
        <source>Scene or model</source>
        <translation>Scéna nebo model</translation>
    </message>
    <message>
        <source>as the server has it now</source>
        <translation>jak ji má nyní server</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Cameras (*.cam)</source>
        <translation>Kamery (*.cam)</translation>
    </message>
    <message>
        <source>from scene</source>
        <translation>ze scény</translation>
    </message>
    <message>
        <source>as in scene</source>
        <translation>jako ve scéně</translation>
    </message>
    <message>
        <source>List of cameras</source>
        <translation>Seznam kamer</translation>
    </message>
    <message>
        <source>Lists (*.lst *.txt)</source>
        <translation>Seznamy (*.lst *.txt)</translation>
    </message>
    <message>
        <source>all; or such as 1-100</source>
        <translation>všechny; nebo třeba 1-100</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Snímky</translation>
    </message>
    <message>
        <source>Output file</source>
        <translation>Výstupní soubor</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>no film</source>
        <translation>bez filmu</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <source>Settings (*.set)</source>
        <translation>Nastavení (*.set)</translation>
    </message>
    <message>
        <source>custom</source>
        <translation>vlastní</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Rozlišení</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Šířka</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Anti-aliasing</source>
        <translation>Vyhlazování hran</translation>
    </message>
    <message>
        <source>on</source>
        <translation>zapnuto</translation>
    </message>
    <message>
        <source>off</source>
        <translation>vypnuto</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Zastínění okolím</translation>
    </message>
    <message>
        <source>Rays of the ambient occlusion</source>
        <translation>Paprsky zastínění okolím</translation>
    </message>
    <message>
        <source> rays per point</source>
        <translation> paprsků na bod</translation>
    </message>
    <message>
        <source>Bloom</source>
        <translation>Záře</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> bodů</translation>
    </message>
    <message>
        <source>&amp;What:</source>
        <translation>&amp;Co:</translation>
    </message>
    <message>
        <source>&amp;Scene or model:</source>
        <translation>&amp;Scéna nebo model:</translation>
    </message>
    <message>
        <source>&amp;Camera:</source>
        <translation>&amp;Kamera:</translation>
    </message>
    <message>
        <source>&amp;List:</source>
        <translation>Se&amp;znam:</translation>
    </message>
    <message>
        <source>&amp;Frames:</source>
        <translation>S&amp;nímky:</translation>
    </message>
    <message>
        <source>F&amp;ilm:</source>
        <translation>Fi&amp;lm:</translation>
    </message>
    <message>
        <source>&amp;Output:</source>
        <translation>&amp;Výstup:</translation>
    </message>
    <message>
        <source>&amp;Resolution:</source>
        <translation>R&amp;ozlišení:</translation>
    </message>
    <message>
        <source>&amp;Anti-aliasing:</source>
        <translation>Vyhlazování &amp;hran:</translation>
    </message>
    <message>
        <source>Ambient occl&amp;usion:</source>
        <translation>Zas&amp;tínění okolím:</translation>
    </message>
    <message>
        <source>&amp;Bloom:</source>
        <translation>Zář&amp;e:</translation>
    </message>
    <message>
        <source>S&amp;ettings:</source>
        <translation>N&amp;astavení:</translation>
    </message>
    <message>
        <source>same as viewport</source>
        <translation>jako živý obraz</translation>
    </message>
    <message>
        <source>from recording</source>
        <translation>podle záznamu</translation>
    </message>
    <message>
        <source>no images; or such as frame_####.png</source>
        <translation>bez obrázků; nebo třeba frame_####.png</translation>
    </message>
    <message>
        <source>Choose a scene or a model.</source>
        <translation>Vyberte scénu nebo model.</translation>
    </message>
    <message>
        <source>The camera&apos;s file is not there.</source>
        <translation>Soubor s kamerou neexistuje.</translation>
    </message>
    <message>
        <source>The file of settings is not there.</source>
        <translation>Soubor s nastavením neexistuje.</translation>
    </message>
    <message>
        <source>Choose a list of cameras.</source>
        <translation>Vyberte seznam kamer.</translation>
    </message>
    <message>
        <source>Name a film, images, or both.</source>
        <translation>Zadejte film, obrázky nebo obojí.</translation>
    </message>
    <message>
        <source>Name the file to write.</source>
        <translation>Zadejte výstupní soubor.</translation>
    </message>
    <message>
        <source>fast</source>
        <translation>rychlá</translation>
    </message>
    <message>
        <source>full light</source>
        <translation>úplné světlo</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Kvalita</translation>
    </message>
    <message>
        <source>Samples of path tracing</source>
        <translation>Vzorky sledování cest</translation>
    </message>
    <message>
        <source> samples per pixel</source>
        <translation> vzorků na pixel</translation>
    </message>
    <message>
        <source>&amp;Vary noise per frame</source>
        <translation>&amp;Jiný šum v každém snímku</translation>
    </message>
    <message>
        <source>Noise that stands still in a film looks like dirt on the glass.</source>
        <translation>Šum, který ve filmu stojí, vypadá jako špína na skle.</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>&amp;Kvalita:</translation>
    </message>
    <message>
        <source>by the net</source>
        <translation>sítí</translation>
    </message>
    <message>
        <source>by the small net, faster</source>
        <translation>malou sítí, rychleji</translation>
    </message>
    <message>
        <source>by the large net, slower</source>
        <translation>velkou sítí, pomaleji</translation>
    </message>
    <message>
        <source>by the filter</source>
        <translation>filtrem</translation>
    </message>
    <message>
        <source>Denoise</source>
        <translation>Odstranit šum</translation>
    </message>
    <message>
        <source>De&amp;noise:</source>
        <translation>O&amp;dstranit šum:</translation>
    </message>
    <message>
        <source>a flight of the scene</source>
        <translation>let ze scény</translation>
    </message>
    <message>
        <source>Flight</source>
        <translation>Let</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Snímků za sekundu</translation>
    </message>
    <message>
        <source>Fli&amp;ght:</source>
        <translation>Let kamer&amp;y:</translation>
    </message>
    <message>
        <source>Frames &amp;per second:</source>
        <translation>Snímků za sek&amp;undu:</translation>
    </message>
    <message>
        <source>as recorded, else 25</source>
        <translation>podle záznamu, jinak 25</translation>
    </message>
    <message>
        <source>%1 upright</source>
        <translation>%1 na výšku</translation>
    </message>
</context>
<context>
    <name>gui::RenderOperations</name>
    <message>
        <source>Refined. The next movement shows the live frame again.</source>
        <translation>Zpřesněno. Při dalším pohybu se vrátí živý obraz.</translation>
    </message>
    <message>
        <source>rendering…</source>
        <translation>vykresluje se…</translation>
    </message>
    <message>
        <source>No progressive rendering: %1</source>
        <translation>Bez postupného vykreslování: %1</translation>
    </message>
    <message>
        <source>rendering %1 %</source>
        <translation>vykresluje se %1 %</translation>
    </message>
    <message>
        <source>refined</source>
        <translation>zpřesněno</translation>
    </message>
</context>
<context>
    <name>gui::SaveOperations</name>
    <message>
        <source>Save the scene as</source>
        <translation>Uložit scénu jako</translation>
    </message>
    <message>
        <source>Scenes (*.scn)</source>
        <translation>Scény (*.scn)</translation>
    </message>
    <message>
        <source>Replace a file</source>
        <translation>Nahradit soubor</translation>
    </message>
    <message>
        <source>“%1” was written or changed by hand. Its comments and its layout are lost when it is saved. The old file is kept as “%1~”.</source>
        <translation>Soubor „%1“ byl napsán nebo změněn ručně. Uložením přijde o komentáře a rozvržení. Starý soubor zůstane jako „%1~“.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Nahradit</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Uložit &amp;jako…</translation>
    </message>
    <message>
        <source>Saved as “%1”.</source>
        <translation>Uloženo jako „%1“.</translation>
    </message>
    <message>
        <source>Pack the scene into a new folder</source>
        <translation>Zabalit scénu do nové složky</translation>
    </message>
    <message>
        <source>&amp;Folder:</source>
        <translation>&amp;Složka:</translation>
    </message>
    <message>
        <source>Packing into “%1”…</source>
        <translation>Balím do „%1“…</translation>
    </message>
    <message>
        <source>Packed into “%1”.</source>
        <translation>Zabaleno do „%1“.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Neuložené změny</translation>
    </message>
    <message>
        <source>Save the changes of “%1”?</source>
        <translation>Uložit změny scény „%1“?</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Uložit</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>Za&amp;hodit</translation>
    </message>
    <message>
        <source>&amp;Pack</source>
        <translation>Za&amp;balit</translation>
    </message>
    <message>
        <source>&amp;Stop packing</source>
        <translation>&amp;Zastavit balení</translation>
    </message>
    <message>
        <source>Pack files from elsewhere</source>
        <translation>Zabalit soubory odjinud</translation>
    </message>
    <message>
        <source>The scene names files outside of its folder. With them, the pack shows them to all who get it:

%1</source>
        <translation>Scéna jmenuje soubory mimo svou složku. S nimi je balík ukáže všem, kdo ho dostanou:

%1</translation>
    </message>
    <message>
        <source>&amp;Pack them, too</source>
        <translation>Za&amp;balit i je</translation>
    </message>
    <message>
        <source>Packing: %1 %</source>
        <translation>Balení: %1 %</translation>
    </message>
    <message>
        <source>&apos;, a link to &apos;</source>
        <translation>&apos;, odkaz na &apos;</translation>
    </message>
</context>
<context>
    <name>gui::SectionOperations</name>
    <message>
        <source>Sections</source>
        <translation>Řezy</translation>
    </message>
</context>
<context>
    <name>gui::SectionsPanel</name>
    <message>
        <source>above %1</source>
        <translation>nad %1</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>pod %1</translation>
    </message>
    <message>
        <source>in front of %1</source>
        <translation>před %1</translation>
    </message>
    <message>
        <source>behind %1</source>
        <translation>za %1</translation>
    </message>
    <message>
        <source>right of %1</source>
        <translation>vpravo od %1</translation>
    </message>
    <message>
        <source>left of %1</source>
        <translation>vlevo od %1</translation>
    </message>
    <message>
        <source>beyond %1</source>
        <translation>dále než %1</translation>
    </message>
    <message>
        <source>Cut the model open</source>
        <translation>Rozříznout model</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Řezy</translation>
    </message>
    <message>
        <source>Light and caps</source>
        <translation>Světlo a plochy řezu</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Shora</translation>
    </message>
    <message>
        <source>Take the upper half of the model away</source>
        <translation>Odebrat horní polovinu modelu</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Zepředu</translation>
    </message>
    <message>
        <source>Take the front half of the model away</source>
        <translation>Odebrat přední polovinu modelu</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>Zprava</translation>
    </message>
    <message>
        <source>Take the right half of the model away</source>
        <translation>Odebrat pravou polovinu modelu</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Zde</translation>
    </message>
    <message>
        <source>Cut along the face in the middle of the image: what lies before it is taken away</source>
        <translation>Řez podél plochy uprostřed obrazu: co leží před ní, se odebere</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Obrátit</translation>
    </message>
    <message>
        <source>Take the other side away</source>
        <translation>Odebrat druhou stranu</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odebrat</translation>
    </message>
    <message>
        <source>Remove the selected section</source>
        <translation>Odebrat vybraný řez</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Odebrat vše</translation>
    </message>
    <message>
        <source>The model is whole again</source>
        <translation>Model bude opět celý</translation>
    </message>
    <message>
        <source>Section through the model</source>
        <translation>Řez modelem</translation>
    </message>
    <message>
        <source>Position of the section</source>
        <translation>Poloha řezu</translation>
    </message>
    <message>
        <source>In the coordinates of the model&apos;s file</source>
        <translation>V souřadnicích souboru modelu</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Světlo</translation>
    </message>
    <message>
        <source>Rooms keep their light</source>
        <translation>Místnosti si ponechají světlo</translation>
    </message>
    <message>
        <source>Light falls in</source>
        <translation>Světlo dopadá dovnitř</translation>
    </message>
    <message>
        <source>Whether light, too, passes where the model is taken away</source>
        <translation>Zda i světlo prochází tam, kde je model odebrán</translation>
    </message>
    <message>
        <source>Caps</source>
        <translation>Plochy řezu</translation>
    </message>
    <message>
        <source>Colours of materials</source>
        <translation>Barvy materiálů</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>Jedna barva</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Žádné</translation>
    </message>
    <message>
        <source>Areas that close the solids that are cut</source>
        <translation>Plochy, které uzavírají rozříznutá tělesa</translation>
    </message>
    <message>
        <source>Colour of caps</source>
        <translation>Barva ploch řezu</translation>
    </message>
    <message>
        <source>Hatching</source>
        <translation>Šrafování</translation>
    </message>
    <message>
        <source>Lines across caps</source>
        <translation>Čáry přes plochy řezu</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Barva</translation>
    </message>
</context>
<context>
    <name>gui::ServerKeeper</name>
    <message>
        <source>The server “%1” has ended.</source>
        <translation>Server „%1“ skončil.</translation>
    </message>
</context>
<context>
    <name>gui::ServerProcess</name>
    <message>
        <source>The program RTServer was found neither beside this one nor in PATH.</source>
        <translation>Program RTServer nebyl nalezen vedle tohoto programu ani v PATH.</translation>
    </message>
    <message>
        <source>RTServer cannot be started: %1</source>
        <translation>RTServer nelze spustit: %1</translation>
    </message>
    <message>
        <source>The server was killed or has crashed (signal %1).</source>
        <translation>Server byl násilně ukončen nebo havaroval (signál %1).</translation>
    </message>
    <message>
        <source>The server ended with exit code %1.</source>
        <translation>Server skončil s návratovým kódem %1.</translation>
    </message>
</context>
<context>
    <name>gui::Session</name>
    <message>
        <source>the window left the server</source>
        <translation>okno opustilo server</translation>
    </message>
    <message>
        <source>there is no server</source>
        <translation>žádný server neběží</translation>
    </message>
    <message>
        <source>There is no server “%1”.</source>
        <translation>Server „%1“ neběží.</translation>
    </message>
    <message>
        <source>the server ended before it answered</source>
        <translation>server skončil dříve, než odpověděl</translation>
    </message>
    <message>
        <source>the server takes no commands</source>
        <translation>server nepřijímá příkazy</translation>
    </message>
</context>
<context>
    <name>gui::SettingRow</name>
    <message>
        <source>Default of %1</source>
        <translation>Výchozí hodnota: %1</translation>
    </message>
    <message>
        <source>Back to the default: %1</source>
        <translation>Zpět na výchozí hodnotu: %1</translation>
    </message>
</context>
<context>
    <name>gui::SettingsPanel</name>
    <message>
        <source>All settings but the size as they are without any file</source>
        <translation>Všechna nastavení kromě velikosti jako bez souborů</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Výchozí</translation>
    </message>
    <message>
        <source>Quality:</source>
        <translation>Kvalita:</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Pokročilé</translation>
    </message>
</context>
<context>
    <name>gui::ShareDialog</name>
    <message>
        <source>Share in a browser</source>
        <translation>Sdílet v prohlížeči</translation>
    </message>
    <message>
        <source>&amp;Share</source>
        <translation>&amp;Sdílet</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Spouští se…</translation>
    </message>
    <message>
        <source>S&amp;top sharing</source>
        <translation>&amp;Ukončit sdílení</translation>
    </message>
</context>
<context>
    <name>gui::ShareLinksPage</name>
    <message>
        <source>without a name</source>
        <translation>beze jména</translation>
    </message>
    <message>
        <source>%1 (drives)</source>
        <translation>%1 (řídí)</translation>
    </message>
    <message>
        <source>From another machine: ssh -L %1:127.0.0.1:%1 %2, and then the same links.</source>
        <translation>Z jiného počítače: ssh -L %1:127.0.0.1:%1 %2 a pak tytéž odkazy.</translation>
    </message>
    <message>
        <source>&amp;Driver&apos;s link:</source>
        <translation>Odkaz pro ř&amp;idiče:</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopírovat</translation>
    </message>
    <message>
        <source>&amp;Open here</source>
        <translation>&amp;Otevřít zde</translation>
    </message>
    <message>
        <source>&amp;Viewer&apos;s link:</source>
        <translation>Odkaz pro &amp;diváka:</translation>
    </message>
    <message>
        <source>Co&amp;py</source>
        <translation>Kopíro&amp;vat</translation>
    </message>
    <message>
        <source>Open &amp;here</source>
        <translation>Otevřít &amp;zde</translation>
    </message>
    <message>
        <source>Visitors</source>
        <translation>Návštěvníci</translation>
    </message>
    <message>
        <source>The link was copied.</source>
        <translation>Odkaz byl zkopírován.</translation>
    </message>
    <message>
        <source>No visitors at the moment.</source>
        <translation>Právě teď se nikdo nedívá.</translation>
    </message>
    <message>
        <source>Visitors at the moment: %1 – %2</source>
        <translation>Právě se dívají: %1 – %2</translation>
    </message>
    <message>
        <source>Not encrypted: anyone on the network can see the images and the links.</source>
        <translation>Nešifrováno: kdokoli v síti může vidět obrázky i odkazy.</translation>
    </message>
    <message>
        <source>For any number of visitors who only look.</source>
        <translation>Pro libovolný počet návštěvníků, kteří se jen dívají.</translation>
    </message>
    <message>
        <source>For visitors who may walk, one at a time, and change settings, lights and materials. They cannot load or save anything, nor end the server.</source>
        <translation>Pro návštěvníky, kteří smějí chodit, vždy jeden, a měnit nastavení, světla a materiály. Nemohou nic načíst ani uložit, ani ukončit server.</translation>
    </message>
    <message>
        <source>For visitors who may walk, one at a time. They cannot change, load or save anything, nor end the server.</source>
        <translation>Pro návštěvníky, kteří smějí chodit, vždy jeden. Nemohou nic změnit, načíst ani uložit, ani ukončit server.</translation>
    </message>
    <message>
        <source>&amp;QR code</source>
        <translation>&amp;QR kód</translation>
    </message>
    <message>
        <source>Q&amp;R code</source>
        <translation>Q&amp;R kód</translation>
    </message>
    <message>
        <source>The link is good once, for one page; then the next one is shown here.</source>
        <translation>Odkaz platí jednou, pro jednu stránku; potom je tu další.</translation>
    </message>
    <message>
        <source>Browsers ask once whether to go on. This certificate is known by %1</source>
        <translation>Prohlížeče se jednou zeptají, zda pokračovat. Tento certifikát se pozná podle %1</translation>
    </message>
    <message>
        <source>For any number of visitors who only look, and write notes with their name.</source>
        <translation>Pro libovolný počet návštěvníků, kteří se jen dívají a píší poznámky se svým jménem.</translation>
    </message>
</context>
<context>
    <name>gui::ShareOperations</name>
    <message>
        <source>The browser opens the page.</source>
        <translation>Stránku otevírá prohlížeč.</translation>
    </message>
    <message>
        <source>No browser could be started; copy the link.</source>
        <translation>Žádný prohlížeč nelze spustit; zkopírujte odkaz.</translation>
    </message>
    <message>
        <source>● shared: %1</source>
        <translation>● sdíleno: %1</translation>
    </message>
    <message>
        <source>● shared</source>
        <translation>● sdíleno</translation>
    </message>
    <message>
        <source>The server is no longer shared in browsers: %1</source>
        <translation>Server se už v prohlížečích nesdílí: %1</translation>
    </message>
</context>
<context>
    <name>gui::SharePlanPage</name>
    <message>
        <source>Certificate</source>
        <translation>Certifikát</translation>
    </message>
    <message>
        <source>Certificates (*.pem *.crt);;All files (*)</source>
        <translation>Certifikáty (*.pem *.crt);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Key of the certificate</source>
        <translation>Klíč certifikátu</translation>
    </message>
    <message>
        <source>Keys (*.pem *.key);;All files (*)</source>
        <translation>Klíče (*.pem *.key);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>this machine only</source>
        <translation>jen z tohoto počítače</translation>
    </message>
    <message>
        <source>other machines, by %1 (%2)</source>
        <translation>z jiných počítačů přes %1 (%2)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádné</translation>
    </message>
    <message>
        <source>&amp;From:</source>
        <translation>O&amp;dkud:</translation>
    </message>
    <message>
        <source>&amp;Encryption:</source>
        <translation>Ši&amp;frování:</translation>
    </message>
    <message>
        <source>&amp;Certificate:</source>
        <translation>&amp;Certifikát:</translation>
    </message>
    <message>
        <source>&amp;Key:</source>
        <translation>&amp;Klíč:</translation>
    </message>
    <message>
        <source>Other machines get there by ssh; the next page shows how.</source>
        <translation>Z jiných počítačů se sem dá dostat přes ssh; jak, ukáže další stránka.</translation>
    </message>
    <message>
        <source>Browsers warn of a certificate that they do not know.</source>
        <translation>Prohlížeče varují před certifikátem, který neznají.</translation>
    </message>
    <message>
        <source>&amp;Visitors may walk, one at a time</source>
        <translation>&amp;Návštěvníci smějí chodit, vždy jeden</translation>
    </message>
    <message>
        <source>They may also change settings, &amp;lights and materials</source>
        <translation>Smějí také měnit nastavení, s&amp;větla a materiály</translation>
    </message>
    <message>
        <source>Show what this server renders in web pages: visitors walk or look there and need to install nothing. Anyone with a link can do what it allows, until you stop sharing.</source>
        <translation>Ukáže na webových stránkách, co tento server vykresluje: návštěvníci tam chodí nebo se dívají a nemusejí nic instalovat. Kdo má odkaz, může, co odkaz dovoluje, dokud sdílení neukončíte.</translation>
    </message>
    <message>
        <source>Without encryption everybody in between can read images and links, and use the links. Choose this only in a network that you trust.</source>
        <translation>Bez šifrování může kdokoli po cestě číst obraz i odkazy a odkazy použít. Volte to jen v síti, které důvěřujete.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Odkud</translation>
    </message>
    <message>
        <source>Encryption</source>
        <translation>Šifrování</translation>
    </message>
    <message>
        <source>TLS, by a certificate that is made</source>
        <translation>TLS, certifikátem, který se vytvoří</translation>
    </message>
    <message>
        <source>TLS, by a certificate of yours</source>
        <translation>TLS, vaším certifikátem</translation>
    </message>
    <message>
        <source>Visitors who only look may &amp;write notes, with their name</source>
        <translation>Návštěvníci, kteří se jen dívají, smějí psát &amp;poznámky, se jménem</translation>
    </message>
</context>
<context>
    <name>gui::SkyFields</name>
    <message>
        <source>Turned by</source>
        <translation>Otočeno o</translation>
    </message>
    <message>
        <source>Turns the environment map, to the right about the up axis</source>
        <translation>Otočí mapu prostředí doprava kolem svislé osy</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Jas</translation>
    </message>
    <message>
        <source>How bright the environment map is; 1 is as its file says</source>
        <translation>Jak je mapa prostředí jasná; 1 je jako v souboru</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Slunce</translation>
    </message>
    <message>
        <source>By date and place</source>
        <translation>Podle data a místa</translation>
    </message>
    <message>
        <source>By direction</source>
        <translation>Podle směru</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Denní doba</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Čas</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Zeměpisná šířka</translation>
    </message>
    <message>
        <source>Degrees north; negative in the south</source>
        <translation>Stupně severně; na jihu záporné</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Zeměpisná délka</translation>
    </message>
    <message>
        <source>Degrees east; negative in the west</source>
        <translation>Stupně východně; na západě záporné</translation>
    </message>
    <message>
        <source>Time zone</source>
        <translation>Časové pásmo</translation>
    </message>
    <message>
        <source>What the clock is ahead of universal time</source>
        <translation>O kolik jsou hodiny napřed před světovým časem</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Sever</translation>
    </message>
    <message>
        <source>Where north is in the scene: from straight ahead to the right</source>
        <translation>Kde je ve scéně sever: od směru vpřed doprava</translation>
    </message>
    <message>
        <source>Direction to the sun</source>
        <translation>Směr ke slunci</translation>
    </message>
    <message>
        <source>Sun direction</source>
        <translation>Směr ke slunci</translation>
    </message>
    <message>
        <source>Along view</source>
        <translation>Ve směru pohledu</translation>
    </message>
    <message>
        <source>Put the sun where the camera looks</source>
        <translation>Umístí slunce tam, kam se dívá kamera</translation>
    </message>
    <message>
        <source>Haze</source>
        <translation>Zákal</translation>
    </message>
    <message>
        <source>2 very clear, 3 clear, 6 hazy, 10 thick</source>
        <translation>2 velmi jasno, 3 jasno, 6 opar, 10 hustý opar</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Síla</translation>
    </message>
    <message>
        <source>How bright sun and sky are; 1 is as in nature</source>
        <translation>Jak jasné jsou slunce a obloha; 1 je jako v přírodě</translation>
    </message>
    <message>
        <source>Ground plane</source>
        <translation>Podklad</translation>
    </message>
    <message>
        <source>A wide ground below the model</source>
        <translation>Široká zem pod modelem</translation>
    </message>
    <message>
        <source>White horizon</source>
        <translation>Bílý obzor</translation>
    </message>
    <message>
        <source>Haze at the horizon, into which a light ground fades</source>
        <translation>Opar na obzoru, do nějž přechází světlá zem</translation>
    </message>
    <message>
        <source>How bright the walls of the studio are</source>
        <translation>Jak jasné jsou stěny ateliéru</translation>
    </message>
</context>
<context>
    <name>gui::StartPage</name>
    <message>
        <source>Open</source>
        <translation>Otevřít</translation>
    </message>
    <message>
        <source>or drop a file here</source>
        <translation>nebo sem přetáhněte soubor</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Příklady</translation>
    </message>
    <message>
        <source>Click into the image: the mouse looks around, W A S D move. Esc releases both.
F walks on the ground: Shift runs, Space jumps, C crouches. F again flies.
Double-click to look somewhere. F1 shows all keys.</source>
        <translation>Klikněte do obrazu: myší se rozhlížíte, W A S D vás posouvají. Esc obojí uvolní.
F: chůze (Shift běh, mezerník skok, C dřep), dalším F zase létáte.
Dvojklik natočí pohled. F1 ukáže všechny klávesy.</translation>
    </message>
    <message>
        <source>To walk</source>
        <translation>Procházka</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Naposledy otevřené</translation>
    </message>
    <message>
        <source>Open a scene or a &amp;model…</source>
        <translation>Otevřít scénu nebo &amp;model…</translation>
    </message>
    <message>
        <source>Connect to a &amp;running server…</source>
        <translation>Připojit k &amp;běžícímu serveru…</translation>
    </message>
</context>
<context>
    <name>gui::StartServerDialog</name>
    <message>
        <source>Scene or model</source>
        <translation>Scéna nebo model</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Cameras (*.cam);;All files (*)</source>
        <translation>Kamery (*.cam);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <source>Settings (*.set);;All files (*)</source>
        <translation>Nastavení (*.set);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Šířka</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Vlákna</translation>
    </message>
    <message>
        <source>all cores</source>
        <translation>všechna jádra</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádné</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> snímků/s</translation>
    </message>
    <message>
        <source>&amp;Keep the server running when the window closes</source>
        <translation>Po zavření okna nechat server běže&amp;t</translation>
    </message>
    <message>
        <source>Fewer &amp;pixels while something moves, so that it moves smoothly</source>
        <translation>Za pohybu kreslit méně &amp;bodů, aby byl plynulý</translation>
    </message>
    <message>
        <source>Start new server</source>
        <translation>Spustit nový server</translation>
    </message>
    <message>
        <source>as large as the window</source>
        <translation>podle okna</translation>
    </message>
    <message>
        <source>from scene</source>
        <translation>ze scény</translation>
    </message>
    <message>
        <source>custom</source>
        <translation>vlastní</translation>
    </message>
    <message>
        <source>&amp;Scene or model:</source>
        <translation>&amp;Scéna nebo model:</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>Náz&amp;ev:</translation>
    </message>
    <message>
        <source>&amp;Resolution:</source>
        <translation>&amp;Rozlišení:</translation>
    </message>
    <message>
        <source>&amp;Camera:</source>
        <translation>&amp;Kamera:</translation>
    </message>
    <message>
        <source>S&amp;ettings:</source>
        <translation>&amp;Nastavení:</translation>
    </message>
    <message>
        <source>&amp;Threads:</source>
        <translation>&amp;Vlákna:</translation>
    </message>
    <message>
        <source>Frame &amp;limit:</source>
        <translation>&amp;Omezení snímků:</translation>
    </message>
    <message>
        <source>&amp;More options:</source>
        <translation>&amp;Další volby:</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Spustit</translation>
    </message>
    <message>
        <source>A name has 1 to 32 letters, digits, “_” or “-”.</source>
        <translation>Název má 1 až 32 písmen, číslic, „_“ nebo „-“.</translation>
    </message>
    <message>
        <source>The camera&apos;s file is not there.</source>
        <translation>Soubor s kamerou neexistuje.</translation>
    </message>
    <message>
        <source>The file of settings is not there.</source>
        <translation>Soubor s nastavením neexistuje.</translation>
    </message>
    <message>
        <source>Choose a scene or a model.</source>
        <translation>Vyberte scénu nebo model.</translation>
    </message>
</context>
<context>
    <name>gui::StatisticsDialog</name>
    <message>
        <source>Statistics</source>
        <translation>Statistika</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Server</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stav</translation>
    </message>
    <message>
        <source>Frames/s</source>
        <translation>Snímků/s</translation>
    </message>
    <message>
        <source>Frame time</source>
        <translation>Doba snímku</translation>
    </message>
    <message>
        <source>Displayed</source>
        <translation>Zobrazeno</translation>
    </message>
    <message>
        <source>Display latency</source>
        <translation>Zpoždění zobrazení</translation>
    </message>
    <message>
        <source>Rays/s</source>
        <translation>Paprsků/s</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Rozlišení</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Trojúhelníky</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Režim</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Oko</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Expozice</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>zaneprázdněn</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nepřipojeno</translation>
    </message>
    <message>
        <source>loading</source>
        <translation>načítá</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>pozastaven</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>hotovo</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>kreslí</translation>
    </message>
    <message>
        <source>%1 (process %2)</source>
        <translation>%1 (proces %2)</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 snímků/s</translation>
    </message>
    <message>
        <source>%1 million</source>
        <translation>%1 milionů</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>chůze</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>létání</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Obraz</translation>
    </message>
    <message>
        <source>Indirect light</source>
        <translation>Nepřímé světlo</translation>
    </message>
    <message>
        <source>±%1 %</source>
        <translation>±%1 %</translation>
    </message>
</context>
<context>
    <name>gui::SurroundingsOperations</name>
    <message>
        <source>Lit by a sky</source>
        <translation>Osvětleno oblohou</translation>
    </message>
    <message>
        <source>Lit as in a studio</source>
        <translation>Osvětleno jako ve studiu</translation>
    </message>
    <message>
        <source>Lit by a light beside you</source>
        <translation>Osvětleno světlem vedle vás</translation>
    </message>
    <message>
        <source>Neither sky nor environment map</source>
        <translation>Ani obloha, ani mapa prostředí</translation>
    </message>
    <message>
        <source>An environment map lights a scene. Open that first.</source>
        <translation>Mapa prostředí osvětluje scénu. Nejprve nějakou otevřete.</translation>
    </message>
    <message>
        <source>Lit by %1</source>
        <translation>Osvětluje %1</translation>
    </message>
    <message>
        <source>Open an environment map</source>
        <translation>Otevřít mapu prostředí</translation>
    </message>
    <message>
        <source>Environment maps (*.hdr *.exr *.pfm *.png *.jpg);;All files (*)</source>
        <translation>Mapy prostředí (*.hdr *.exr *.pfm *.png *.jpg);;Všechny soubory (*)</translation>
    </message>
</context>
<context>
    <name>gui::UpAndUnitDialog</name>
    <message>
        <source>Millimetres</source>
        <translation>Milimetry</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centimetry</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metry</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Palce</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Stopy</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Jiná</translation>
    </message>
    <message>
        <source>Up axis and unit</source>
        <translation>Svislá osa a jednotka</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>This axis of the model points to the sky</source>
        <translation>Tato osa modelu míří vzhůru</translation>
    </message>
    <message>
        <source>What the model&apos;s numbers count; walking and depth of field go by it</source>
        <translation>V čem jsou čísla modelu; řídí se tím chůze a hloubka ostrosti</translation>
    </message>
    <message>
        <source>How long a unit of the model is</source>
        <translation>Jak dlouhá je jednotka modelu</translation>
    </message>
    <message>
        <source>&amp;Up:</source>
        <translation>&amp;Vzhůru:</translation>
    </message>
    <message>
        <source>U&amp;nit:</source>
        <translation>&amp;Jednotka:</translation>
    </message>
    <message>
        <source>&amp;Length of a unit:</source>
        <translation>&amp;Délka jednotky:</translation>
    </message>
    <message>
        <source>&amp;As guessed</source>
        <translation>&amp;Podle odhadu</translation>
    </message>
    <message>
        <source>By the format, the program that wrote it, and the shape of the model</source>
        <translation>Podle formátu, programu, který jej zapsal, a tvaru modelu</translation>
    </message>
</context>
<context>
    <name>gui::VariantNameDialog</name>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Jméno:</translation>
    </message>
</context>
<context>
    <name>gui::VariantOperations</name>
    <message>
        <source>Variant %1</source>
        <translation>Varianta %1</translation>
    </message>
    <message>
        <source>Keep as a variant</source>
        <translation>Uložit jako variantu</translation>
    </message>
    <message>
        <source>Kept as the variant “%1”.</source>
        <translation>Uloženo jako varianta „%1“.</translation>
    </message>
    <message>
        <source>&amp;Without a variant</source>
        <translation>&amp;Bez varianty</translation>
    </message>
    <message>
        <source>Without a variant</source>
        <translation>Bez varianty</translation>
    </message>
    <message>
        <source>&amp;Update “%1”</source>
        <translation>&amp;Aktualizovat „%1“</translation>
    </message>
    <message>
        <source>“%1” is what is shown now.</source>
        <translation>„%1“ je to, co je teď zobrazeno.</translation>
    </message>
    <message>
        <source>&amp;Rename “%1”…</source>
        <translation>&amp;Přejmenovat „%1“…</translation>
    </message>
    <message>
        <source>Rename a variant</source>
        <translation>Přejmenovat variantu</translation>
    </message>
    <message>
        <source>R&amp;emove “%1”</source>
        <translation>&amp;Odstranit „%1“</translation>
    </message>
    <message>
        <source>“%1” is removed. What is shown stays.</source>
        <translation>„%1“ je odstraněna. Co je zobrazeno, zůstává.</translation>
    </message>
</context>
<context>
    <name>gui::ViewCube</name>
    <message>
        <source>FRONT</source>
        <translation>ZPŘEDU</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>ZEZADU</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>ZLEVA</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>ZPRAVA</translation>
    </message>
    <message>
        <source>TOP</source>
        <translation>SHORA</translation>
    </message>
    <message>
        <source>BELOW</source>
        <translation>ZDOLA</translation>
    </message>
    <message>
        <source>View cube</source>
        <translation>Krychle pohledu</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Otáčet</translation>
    </message>
    <message>
        <source>Walk</source>
        <translation>Chodit</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>Létat</translation>
    </message>
</context>
<context>
    <name>gui::ViewsStrip</name>
    <message>
        <source>Views</source>
        <translation>Pohledy</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Přidat</translation>
    </message>
    <message>
        <source>Keep the current view</source>
        <translation>Uchovat aktuální pohled</translation>
    </message>
    <message>
        <source>&amp;Go there</source>
        <translation>&amp;Jít tam</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>Přej&amp;menovat</translation>
    </message>
    <message>
        <source>Re&amp;place by the current view</source>
        <translation>&amp;Nahradit aktuálním pohledem</translation>
    </message>
    <message>
        <source>Move &amp;left</source>
        <translation>Přesunout do&amp;leva</translation>
    </message>
    <message>
        <source>Move r&amp;ight</source>
        <translation>Přesunout do&amp;prava</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Smazat</translation>
    </message>
    <message>
        <source>%1
Alt+%2</source>
        <translation>%1
Alt+%2</translation>
    </message>
    <message>
        <source>Its image comes when you go there.</source>
        <translation>Obrázek přibude, až tam přejdete.</translation>
    </message>
</context>
</TS>
