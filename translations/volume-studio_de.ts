<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>cases</name>
    <message>
        <source>Exploring a head</source>
        <translation>Ein Kopf wird erkundet</translation>
    </message>
    <message>
        <source>A wide range of values in every mode; then the peel opens the face, the laser burns along the left side with varying pressure, and the drill cuts away the upper right.</source>
        <translation>Ein weiter Wertebereich in jedem Modus; dann öffnet das Schälen das Gesicht, der Laser brennt mit wechselndem Druck an der linken Seite entlang, und der Bohrer schneidet rechts oben.</translation>
    </message>
    <message>
        <source>The ventricles</source>
        <translation>Die Ventrikel</translation>
    </message>
    <message>
        <source>A corner of the head is peeled open; a stroke on one lateral ventricle grows too far, is played backward, and grows on under a rule for the gradient; then the other one.</source>
        <translation>Eine Ecke des Kopfes wird aufgeschält; ein Strich auf einem Seitenventrikel wächst zu weit, wird zurückgespielt und wächst unter einer Regel für den Gradienten weiter; dann der andere.</translation>
    </message>
    <message>
        <source>Opening a skull</source>
        <translation>Ein Schädel wird geöffnet</translation>
    </message>
    <message>
        <source>A circular region on top of the head is peeled off, layer by layer, and what was taken off is pasted beside it.</source>
        <translation>Ein kreisrunder Bereich oben auf dem Kopf wird Schicht für Schicht abgeschält, und das Abgenommene wird daneben eingefügt.</translation>
    </message>
    <message>
        <source>White and grey matter</source>
        <translation>Weiße und graue Substanz</translation>
    </message>
    <message>
        <source>Strokes on the visible brain grow to white and grey matter, which are pulled out beside the head, one inside the other, while they stay coloured in their place.</source>
        <translation>Striche auf dem sichtbaren Hirn wachsen zu weißer und grauer Substanz, die neben den Kopf herausgezogen werden, eine in der anderen, und an ihrem Platz gefärbt bleiben.</translation>
    </message>
    <message>
        <source>A tooth</source>
        <translation>Ein Zahn</translation>
    </message>
    <message>
        <source>The laser clears a molar from both sides, the drill clears what is around it; a stroke makes it a segment, which is pulled out and enlarged.</source>
        <translation>Der Laser legt einen Backenzahn von beiden Seiten frei, der Bohrer das, was um ihn ist; ein Strich macht ihn zum Segment, das herausgezogen und vergrößert wird.</translation>
    </message>
    <message>
        <source>Arteries of a head</source>
        <translation>Arterien eines Kopfes</translation>
    </message>
    <message>
        <source>A zigzag stroke across a maximum intensity projection seeds the arteries; growth runs into other tissue, is played backward, and the vessels are pulled out.</source>
        <translation>Ein Zickzackstrich über eine Maximumprojektion sät die Arterien; das Wachstum läuft in anderes Gewebe, wird zurückgespielt, und die Gefäße werden herausgezogen.</translation>
    </message>
    <message>
        <source>An aorta with a stent</source>
        <translation>Eine Aorta mit Stent</translation>
    </message>
    <message>
        <source>A stroke on the stent grows both ways along the aorta, seen beside the scan while it grows, leaks into bone, is played backward, and goes on from further strokes.</source>
        <translation>Ein Strich auf dem Stent wächst in beide Richtungen der Aorta, dabei neben dem Scan zu sehen, läuft in Knochen aus, wird zurückgespielt und geht von weiteren Strichen aus weiter.</translation>
    </message>
    <message>
        <source>Pelvis, spine and ribs</source>
        <translation>Becken, Wirbelsäule und Rippen</translation>
    </message>
    <message>
        <source>Strokes from several sides make segments of pelvis, ribs and spine; the scan is drilled open around them, and they are pulled apart and enlarged.</source>
        <translation>Striche von mehreren Seiten machen Segmente aus Becken, Rippen und Wirbelsäule; der Scan wird um sie herum aufgebohrt, und sie werden auseinandergezogen und vergrößert.</translation>
    </message>
    <message>
        <source>A colon</source>
        <translation>Ein Dickdarm</translation>
    </message>
    <message>
        <source>The wall of the abdomen is peeled open; strokes on the colon grow in a low range, where its gas is, and then in a high one, where the rest is.</source>
        <translation>Die Bauchwand wird aufgeschält; Striche auf dem Dickdarm wachsen in einem niedrigen Bereich, wo sein Gas ist, und dann in einem hohen, wo der Rest ist.</translation>
    </message>
    <message>
        <source>An exploded head</source>
        <translation>Ein Kopf, auseinandergezogen</translation>
    </message>
    <message>
        <source>From above, a ring is drilled through three quarters of a head, and the shell is pasted away from what it holds.</source>
        <translation>Von oben wird ein Ring durch drei Viertel eines Kopfes gebohrt, und die Schale wird von dem weg eingefügt, was sie umschließt.</translation>
    </message>
    <message>
        <source>(a) A wide range of intensities is selected, and a transfer function of intensity gives it colours: maximum intensity projection, X-ray and surface.</source>
        <translation>(a) Ein weiter Intensitätsbereich wird gewählt, und eine Transferfunktion der Intensität gibt ihm Farben: Maximumprojektion, Röntgen und Oberfläche.</translation>
    </message>
    <message>
        <source>(b) The peeling tool is chosen and a region is drawn on the face.</source>
        <translation>(b) Das Schälwerkzeug wird gewählt und ein Bereich auf das Gesicht gezeichnet.</translation>
    </message>
    <message>
        <source>(c) The pen is dragged down, and layer after layer comes off under the mask.</source>
        <translation>(c) Der Stift wird nach unten gezogen, und unter der Maske löst sich Lage um Lage.</translation>
    </message>
    <message>
        <source>(d) The region is peeled off and shows what lies beneath the skin.</source>
        <translation>(d) Der Bereich ist abgeschält und zeigt, was unter der Haut liegt.</translation>
    </message>
    <message>
        <source>(e) The laser is chosen and its tool shape is drawn on the left side of the head.</source>
        <translation>(e) Der Laser wird gewählt und seine Werkzeugform auf die linke Kopfseite gezeichnet.</translation>
    </message>
    <message>
        <source>(f) The pen is led over the skull with varying pressure: the harder it presses, the deeper the laser burns.</source>
        <translation>(f) Der Stift wird mit wechselndem Druck über den Schädel geführt: Je stärker er drückt, desto tiefer brennt der Laser.</translation>
    </message>
    <message>
        <source>(g) The side of the head is cut open.</source>
        <translation>(g) Die Kopfseite ist aufgeschnitten.</translation>
    </message>
    <message>
        <source>(h) The drill is chosen and its tool shape is drawn at the upper right of the head.</source>
        <translation>(h) Der Bohrer wird gewählt und seine Werkzeugform rechts oben am Kopf gezeichnet.</translation>
    </message>
    <message>
        <source>(i) Under pressure the drill goes along the view, and works its way in as the pen goes to and fro.</source>
        <translation>(i) Unter Druck dringt der Bohrer in Blickrichtung vor und arbeitet sich hinein, während der Stift hin- und herfährt.</translation>
    </message>
    <message>
        <source>(j) The sculpture: the brain shows through the windows that were cut in the head.</source>
        <translation>(j) Die Skulptur: Durch die Fenster, die in den Kopf geschnitten wurden, ist das Gehirn zu sehen.</translation>
    </message>
    <message>
        <source>(a) A low range of intensities is selected: in the X-ray the ventricles are bright within the brain.</source>
        <translation>(a) Ein niedriger Intensitätsbereich wird gewählt: Im Röntgenbild liegen die Ventrikel hell im Gehirn.</translation>
    </message>
    <message>
        <source>(b) The range is widened so that sections can be read; the peeling tool is chosen and a region is drawn at the upper left corner of the head.</source>
        <translation>(b) Der Intensitätsbereich wird erweitert, damit Schnittflächen lesbar werden; das Schälwerkzeug wird gewählt und ein Bereich an der oberen linken Ecke des Kopfes gezeichnet.</translation>
    </message>
    <message>
        <source>(c) Scalp and skull come off under the mask, down to the folds of the brain.</source>
        <translation>(c) Unter der Maske lösen sich Kopfhaut und Schädel, bis hinab zu den Hirnwindungen.</translation>
    </message>
    <message>
        <source>(d) Two smaller regions are peeled within the first, each deeper than the last, until both lateral ventricles lie open.</source>
        <translation>(d) Innerhalb des ersten Bereichs werden zwei kleinere geschält, jeder tiefer als der vorige, bis beide Seitenventrikel offen liegen.</translation>
    </message>
    <message>
        <source>(e) The segmentation tool is chosen and a stroke is drawn on the left lateral ventricle.</source>
        <translation>(e) Das Segmentierungswerkzeug wird gewählt und ein Strich auf den linken Seitenventrikel gezeichnet.</translation>
    </message>
    <message>
        <source>(f) Growth without constraints fills the ventricle, breaks out of it and spreads over the brain&apos;s surface.</source>
        <translation>(f) Ohne Einschränkungen füllt das Wachstum den Ventrikel, bricht aus ihm hervor und breitet sich über die Hirnoberfläche aus.</translation>
    </message>
    <message>
        <source>(g) Growth is played backward until the left ventricle alone is left, and then forward again where the gradient&apos;s magnitude is small.</source>
        <translation>(g) Das Wachstum wird zurückgespielt, bis nur noch der linke Ventrikel übrig ist, und läuft dann dort wieder vorwärts, wo der Gradientenbetrag klein ist.</translation>
    </message>
    <message>
        <source>(h) A stroke is drawn on the right lateral ventricle.</source>
        <translation>(h) Ein Strich wird auf den rechten Seitenventrikel gezeichnet.</translation>
    </message>
    <message>
        <source>(i) It grows under the same constraint.</source>
        <translation>(i) Er wächst unter derselben Einschränkung.</translation>
    </message>
    <message>
        <source>(j) Growth ends by itself; both ventricles are brought to their edge and shown as surfaces within the head as an X-ray.</source>
        <translation>(j) Das Wachstum endet von selbst; beide Ventrikel werden bis an ihren Rand geführt und als Oberflächen im Röntgenbild des Kopfes gezeigt.</translation>
    </message>
    <message>
        <source>(a) The peeling tool is chosen and a circle is drawn on the top of the head, seen from above.</source>
        <translation>(a) Das Schälwerkzeug wird gewählt und in der Ansicht von oben ein Kreis auf den Scheitel des Kopfes gezeichnet.</translation>
    </message>
    <message>
        <source>(b) The pen is dragged down and the first layers come off: scalp and skull.</source>
        <translation>(b) Der Stift wird nach unten gezogen, und die ersten Lagen lösen sich: Kopfhaut und Schädel.</translation>
    </message>
    <message>
        <source>(c) Dragged further down, it takes more layers: the folds of the brain are cut open.</source>
        <translation>(c) Weiter nach unten gezogen, nimmt er mehr Lagen weg: Die Hirnwindungen werden aufgeschnitten.</translation>
    </message>
    <message>
        <source>(d) What was cut away is pasted beside the head, turned so that its inside is seen.</source>
        <translation>(d) Das Weggeschnittene wird neben dem Kopf eingefügt, so gedreht, dass seine Innenseite zu sehen ist.</translation>
    </message>
    <message>
        <source>(a) A middle to high range of intensities is selected: X-ray and surface.</source>
        <translation>(a) Ein mittlerer bis hoher Intensitätsbereich wird gewählt: Röntgen und Oberfläche.</translation>
    </message>
    <message>
        <source>(b) With the left side of the head peeled open, strokes are drawn directly on the white matter.</source>
        <translation>(b) Bei aufgeschälter linker Kopfseite werden Striche direkt auf die weiße Substanz gezeichnet.</translation>
    </message>
    <message>
        <source>(c) The region starts to grow.</source>
        <translation>(c) Die Region beginnt zu wachsen.</translation>
    </message>
    <message>
        <source>(d) It spreads from gyrus to gyrus, seen from the side.</source>
        <translation>(d) Sie breitet sich von Gyrus zu Gyrus aus, von der Seite gesehen.</translation>
    </message>
    <message>
        <source>(e) Growth ends by itself when all white matter is reached, seen at an angle; pinholes of noise are filled.</source>
        <translation>(e) Das Wachstum endet von selbst, sobald die ganze weiße Substanz erreicht ist, hier schräg gesehen; nadelfeine Löcher durch Rauschen werden gefüllt.</translation>
    </message>
    <message>
        <source>(e) Grey matter is a second segment: strokes on the cortex grow in a wider range, and only what lies within 9 mm of white matter is kept.</source>
        <translation>(e) Die graue Substanz ist ein zweites Segment: Striche auf der Hirnrinde wachsen in einem breiteren Bereich, und nur was höchstens 9 mm von weißer Substanz entfernt ist, bleibt.</translation>
    </message>
    <message>
        <source>(f) Both are tinted where they lie in the scan.</source>
        <translation>(f) Beide werden dort gefärbt, wo sie im Scan liegen.</translation>
    </message>
    <message>
        <source>(f) Both are pulled out beside the scan: under the peeled window white matter lies within grey matter.</source>
        <translation>(f) Beide werden neben den Scan herausgezogen: Unter dem aufgeschälten Fenster liegt die weiße Substanz in der grauen.</translation>
    </message>
    <message>
        <source>(a) A high range of intensities is selected, so that bone and teeth remain: as an X-ray, and as a surface coloured by a transfer function over the intensity.</source>
        <translation>(a) Ein hoher Intensitätsbereich wird gewählt, sodass Knochen und Zähne übrig bleiben: als Röntgenbild und als Oberfläche, gefärbt durch eine Transferfunktion über der Intensität.</translation>
    </message>
    <message>
        <source>(b) The head is turned to its left side and the first lower molar looked at closely. A small circle becomes the tip of the laser.</source>
        <translation>(b) Der Kopf wird zu seiner linken Seite gedreht und der erste untere große Backenzahn aus der Nähe betrachtet. Ein kleiner Kreis wird zur Spitze des Lasers.</translation>
    </message>
    <message>
        <source>(c) The pen goes down before the molar, around below its roots and up behind it, pressing harder where the jaw is thick.</source>
        <translation>(c) Der Stift fährt vor dem Backenzahn hinab, unter dessen Wurzeln herum und hinter ihm hinauf; wo der Kiefer dick ist, drückt er stärker.</translation>
    </message>
    <message>
        <source>(d) With less pressure the laser takes the bone off the roots, which show pale.</source>
        <translation>(d) Mit weniger Druck nimmt der Laser den Knochen von den Wurzeln, die sich blass zeigen.</translation>
    </message>
    <message>
        <source>(e) From the other side, with the viewer in the mouth, the same tool goes down before and behind the molar.</source>
        <translation>(e) Von der anderen Seite, mit dem Betrachter im Mund, fährt dasselbe Werkzeug vor und hinter dem Backenzahn hinab.</translation>
    </message>
    <message>
        <source>(f) Here too the bone over the roots is taken off with less pressure.</source>
        <translation>(f) Auch hier wird der Knochen über den Wurzeln mit weniger Druck abgetragen.</translation>
    </message>
    <message>
        <source>(g) The drill, with a circle, removes what surrounds the roots, there and back again; a smaller one parts the crown from its neighbours.</source>
        <translation>(g) Der Bohrer, mit einem Kreis, entfernt, was die Wurzeln umgibt, hin und wieder zurück; ein kleinerer trennt die Krone von ihren Nachbarn.</translation>
    </message>
    <message>
        <source>(h) The range is raised until the bone falls away and the molar stands alone. A stroke that covers most of it sets the seeds.</source>
        <translation>(h) Der Bereich wird angehoben, bis der Knochen wegfällt und der Backenzahn allein dasteht. Ein Strich, der ihn größtenteils bedeckt, setzt die Saat.</translation>
    </message>
    <message>
        <source>(i) The region grows, with no other rule than the range and the cuts, and stops at the molar&apos;s edge.</source>
        <translation>(i) Die Region wächst, ohne andere Regel als den Bereich und die Schnitte, und hält am Rand des Backenzahns an.</translation>
    </message>
    <message>
        <source>(j) The molar is pulled out and enlarged beside the jaw that it comes from.</source>
        <translation>(j) Der Backenzahn wird herausgezogen und neben dem Kiefer, aus dem er stammt, vergrößert.</translation>
    </message>
    <message>
        <source>The file does not say where this head&apos;s crown and face are: the scan is set upright.</source>
        <translation>Aus der Datei geht nicht hervor, wo Scheitel und Gesicht dieses Kopfes sind: Der Scan wird aufrecht gestellt.</translation>
    </message>
    <message>
        <source>(d) Lightly pressed, the laser takes the thin bone off the roots. The section shows them pale in the jaw.</source>
        <translation>(d) Mit leichtem Druck nimmt der Laser den dünnen Knochen von den Wurzeln. Die Schnittfläche zeigt sie blass im Kiefer.</translation>
    </message>
    <message>
        <source>(e) From the other side, with the viewer in the mouth, the same tool goes around the molar in the same way.</source>
        <translation>(e) Von der anderen Seite, mit dem Betrachter im Mund, fährt dasselbe Werkzeug auf gleiche Weise um den Backenzahn.</translation>
    </message>
    <message>
        <source>(f) Here too the bone over the roots is taken off with light pressure.</source>
        <translation>(f) Auch hier wird der Knochen über den Wurzeln mit leichtem Druck abgetragen.</translation>
    </message>
    <message>
        <source>(g) The drill, with a larger circle, removes what surrounds the molar: its neighbours&apos; touching flanks and the bone beside it, there and back again.</source>
        <translation>(g) Der Bohrer, mit einem größeren Kreis, entfernt, was den Backenzahn umgibt: die anliegenden Flanken der Nachbarzähne und den Knochen daneben, hin und wieder zurück.</translation>
    </message>
    <message>
        <source>(a) A high range of intensity leaves the vessels of the head: as an X-ray, then as maximum intensity projection.</source>
        <translation>(a) Ein hoher Intensitätsbereich lässt die Gefäße des Kopfes übrig: als Röntgenbild, dann als Maximumprojektion.</translation>
    </message>
    <message>
        <source>(b) Seen from above, a zigzag stroke of seeds is drawn across the vessels.</source>
        <translation>(b) In der Ansicht von oben wird die Saat als Zickzackstrich quer über die Gefäße gezeichnet.</translation>
    </message>
    <message>
        <source>(c) From all places at once the region grows along the vessels, without constraint.</source>
        <translation>(c) Von allen Stellen zugleich wächst die Region entlang der Gefäße, ohne Einschränkung.</translation>
    </message>
    <message>
        <source>(d) It joins into one tree.</source>
        <translation>(d) Sie verbindet sich zu einem einzigen Baum.</translation>
    </message>
    <message>
        <source>(e) One path runs into unrelated tissue of the face, below on the right.</source>
        <translation>(e) Ein Pfad läuft unten rechts in nicht zugehöriges Gewebe des Gesichts.</translation>
    </message>
    <message>
        <source>(f) The growth is played backward until that is gone, and goes on among the brightest vessels alone.</source>
        <translation>(f) Das Wachstum wird zurückgespielt, bis dieser Ausläufer verschwunden ist, und geht allein in den hellsten Gefäßen weiter.</translation>
    </message>
    <message>
        <source>(g) The vessels are pulled out beside the head and enlarged.</source>
        <translation>(g) Die Gefäße werden neben den Kopf herausgezogen und vergrößert.</translation>
    </message>
    <message>
        <source>(a) A high range of intensity leaves the arteries: as an X-ray, then as maximum intensity projection.</source>
        <translation>(a) Ein hoher Intensitätsbereich lässt die Arterien übrig: als Röntgenbild, dann als Maximumprojektion.</translation>
    </message>
    <message>
        <source>(c) From all places at once the region grows along the arteries, without constraint.</source>
        <translation>(c) Von allen Stellen zugleich wächst die Region entlang der Arterien, ohne Einschränkung.</translation>
    </message>
    <message>
        <source>(e) Through a vein one path runs into the fat of the right cheek, and on to the temple.</source>
        <translation>(e) Durch eine Vene läuft ein Pfad in das Fettgewebe der rechten Wange und weiter zur Schläfe.</translation>
    </message>
    <message>
        <source>(f) The growth is played backward until that is gone, and goes on among the brighter arteries alone.</source>
        <translation>(f) Das Wachstum wird zurückgespielt, bis dieser Ausläufer verschwunden ist, und geht allein in den helleren Arterien weiter.</translation>
    </message>
    <message>
        <source>(g) The arteries are pulled out beside the head and enlarged.</source>
        <translation>(g) Die Arterien werden neben den Kopf herausgezogen und vergrößert.</translation>
    </message>
    <message>
        <source>(a) A high range of intensity is chosen: vessels full of contrast medium, the stent and bone are rendered as surfaces. A short stroke is drawn on the stent.</source>
        <translation>(a) Ein hoher Intensitätsbereich wird gewählt: Gefäße voll Kontrastmittel, der Stent und Knochen werden als Oberflächen dargestellt. Ein kurzer Strich wird auf den Stent gezeichnet.</translation>
    </message>
    <message>
        <source>(b) The region grows without constraint, both ways along the aorta. It is pulled out and seen beside the scan while it grows.</source>
        <translation>(b) Die Region wächst ohne Einschränkung in beide Richtungen entlang der Aorta. Sie wird herausgezogen und ist neben dem Scan zu sehen, während sie wächst.</translation>
    </message>
    <message>
        <source>(c) In the left groin it runs into the hip bone and on over the pelvis.</source>
        <translation>(c) In der linken Leiste läuft sie in das Hüftbein und weiter über das Becken.</translation>
    </message>
    <message>
        <source>(d) The growth is stopped and played backward until the bone is gone.</source>
        <translation>(d) Das Wachstum wird angehalten und zurückgespielt, bis der Knochen verschwunden ist.</translation>
    </message>
    <message>
        <source>(e) A range that ends below the bone keeps to the blood. Strokes are drawn on the arteries of both thighs.</source>
        <translation>(e) Ein Bereich, der unterhalb der Knochenwerte endet, beschränkt sich auf das Blut. Striche werden auf die Arterien beider Oberschenkel gezeichnet.</translation>
    </message>
    <message>
        <source>(f) All regions merge: the whole aorta with its stent and the arteries down to the thighs.</source>
        <translation>(f) Alle Regionen verschmelzen: die ganze Aorta mit ihrem Stent und die Arterien bis hinab zu den Oberschenkeln.</translation>
    </message>
    <message>
        <source>(c) Further on it runs into the spine and along its vessels into a kidney.</source>
        <translation>(c) Im weiteren Verlauf gerät sie in die Wirbelsäule und entlang deren Gefäßen in eine Niere.</translation>
    </message>
    <message>
        <source>(d) The growth is stopped and played backward until the spine is gone.</source>
        <translation>(d) Das Wachstum wird angehalten und zurückgespielt, bis die Wirbelsäule verschwunden ist.</translation>
    </message>
    <message>
        <source>(e) A higher range parts the vessels from the bone. Strokes are drawn on the iliac arteries and on the vessels that leave the aorta.</source>
        <translation>(e) Ein höherer Bereich trennt die Gefäße vom Knochen. Striche werden auf die Beckenarterien und auf die von der Aorta abgehenden Gefäße gezeichnet.</translation>
    </message>
    <message>
        <source>(f) All regions merge: the whole aorta with its stent, and the arteries that leave it.</source>
        <translation>(f) Alle Regionen verschmelzen: die ganze Aorta mit ihrem Stent und die Arterien, die von ihr abgehen.</translation>
    </message>
    <message>
        <source>(a) A high range of intensity leaves the bones: as an X-ray, then as surfaces coloured by the magnitude of the gradient.</source>
        <translation>(a) Ein hoher Intensitätsbereich lässt die Knochen übrig: als Röntgenbild, dann als Oberflächen, gefärbt nach dem Gradientenbetrag.</translation>
    </message>
    <message>
        <source>(b) Seen from the left, a stroke is drawn on the left side of the pelvis.</source>
        <translation>(b) In der Ansicht von links wird ein Strich auf die linke Seite des Beckens gezeichnet.</translation>
    </message>
    <message>
        <source>(c) The view is turned and strokes are drawn on the left ribs.</source>
        <translation>(c) Die Ansicht wird gedreht, und auf die linken Rippen werden Striche gezeichnet.</translation>
    </message>
    <message>
        <source>(d) Turned to the other side: strokes on the right ribs.</source>
        <translation>(d) Zur anderen Seite gedreht: Striche auf den rechten Rippen.</translation>
    </message>
    <message>
        <source>(e) The right side of the pelvis; and from behind the sacrum, which belongs to it, and the spine.</source>
        <translation>(e) Die rechte Seite des Beckens; und von hinten das Kreuzbein, das zum Becken gehört, und die Wirbelsäule.</translation>
    </message>
    <message>
        <source>(f) The scissors fence the spine off from behind and from the side, so that it does not grow into ribs and pelvis. Then the regions start to grow.</source>
        <translation>(f) Die Schere grenzt die Wirbelsäule von hinten und von der Seite ab, damit sie nicht in Rippen und Becken wächst. Dann beginnen die Regionen zu wachsen.</translation>
    </message>
    <message>
        <source>(g) Ribs and pelvis grow without constraint until nothing more grows.</source>
        <translation>(g) Rippen und Becken wachsen ohne Einschränkung, bis nichts mehr wächst.</translation>
    </message>
    <message>
        <source>(h) Seen from above, the drill opens the scan deep down along the view. The bones are spared and stand in it.</source>
        <translation>(h) In der Ansicht von oben öffnet der Bohrer den Scan in Blickrichtung bis tief hinab. Die Knochen werden verschont und stehen darin.</translation>
    </message>
    <message>
        <source>(i) The segments are pulled out, enlarged and set apart.</source>
        <translation>(i) Die Segmente werden herausgezogen, vergrößert und auseinandergerückt.</translation>
    </message>
    <message>
        <source>(b) Seen from the left, a stroke is drawn on the left side of the pelvis and down to the thigh.</source>
        <translation>(b) In der Ansicht von links wird ein Strich auf die linke Seite des Beckens und bis hinab zum Oberschenkel gezeichnet.</translation>
    </message>
    <message>
        <source>(c) The view is turned a little and strokes are drawn on the left ribs.</source>
        <translation>(c) Die Ansicht wird ein wenig gedreht, und auf die linken Rippen werden Striche gezeichnet.</translation>
    </message>
    <message>
        <source>(e) The right side of the pelvis, and the front of the spine.</source>
        <translation>(e) Die rechte Seite des Beckens und die Vorderseite der Wirbelsäule.</translation>
    </message>
    <message>
        <source>(f) The scissors fence the spine off from the front and from the side, so that it does not grow into the pelvis. Then it grows.</source>
        <translation>(f) Die Schere grenzt die Wirbelsäule von vorn und von der Seite ab, damit sie nicht in das Becken wächst. Dann wächst sie.</translation>
    </message>
    <message>
        <source>(g) Ribs and pelvis grow without constraint until nothing more grows. Marrow and gaps are closed.</source>
        <translation>(g) Rippen und Becken wachsen ohne Einschränkung, bis nichts mehr wächst. Markräume und Lücken werden geschlossen.</translation>
    </message>
    <message>
        <source>(h) Seen from above, the drill opens the scan in front of the spine, deep down along the view. The bones are spared and lie open in it.</source>
        <translation>(h) In der Ansicht von oben öffnet der Bohrer den Scan vor der Wirbelsäule, in Blickrichtung bis tief hinab. Die Knochen werden verschont und liegen darin frei.</translation>
    </message>
    <message>
        <source>(a) A low range of intensity shows air and gas: as an X-ray, and as surfaces, where the skin hides the colon.</source>
        <translation>(a) Ein niedriger Intensitätsbereich zeigt Luft und Gas: als Röntgenbild und als Oberflächen, bei denen die Haut den Dickdarm verdeckt.</translation>
    </message>
    <message>
        <source>(b) The peeling tool: an ellipse is drawn on the abdomen.</source>
        <translation>(b) Das Schälwerkzeug: Eine Ellipse wird auf den Bauch gezeichnet.</translation>
    </message>
    <message>
        <source>(c) The wall of the abdomen is peeled off within it, layer by layer, until the gas in the colon lies open.</source>
        <translation>(c) Darin wird die Bauchwand Lage um Lage abgeschält, bis das Gas im Dickdarm offen liegt.</translation>
    </message>
    <message>
        <source>(d) Strokes are drawn on the parts of the colon that hold gas.</source>
        <translation>(d) Striche werden auf die Abschnitte des Dickdarms gezeichnet, die Gas enthalten.</translation>
    </message>
    <message>
        <source>(e) They grow in the low range, held by a rule on the magnitude of the gradient, which is great at the wall.</source>
        <translation>(e) Sie wachsen im niedrigen Bereich, gehalten von einer Regel für den Gradientenbetrag, der an der Wand groß ist.</translation>
    </message>
    <message>
        <source>(f) The gas is filled; no other tissue is reached.</source>
        <translation>(f) Der Gasraum ist gefüllt; kein anderes Gewebe ist erreicht.</translation>
    </message>
    <message>
        <source>(g) In a high range the other part is seen: stool with contrast medium, among the bones. Strokes are drawn on it.</source>
        <translation>(g) In einem hohen Bereich ist der andere Teil zu sehen: Stuhl mit Kontrastmittel, zwischen den Knochen. Striche werden darauf gezeichnet.</translation>
    </message>
    <message>
        <source>(h) They grow in the same way, held by the gradient.</source>
        <translation>(h) Sie wachsen auf dieselbe Weise, gehalten vom Gradienten.</translation>
    </message>
    <message>
        <source>(i) Gas and stool are made one, the seam between them is closed, and a wide range with the abdomen peeled open shows the whole colon.</source>
        <translation>(i) Gas und Stuhl werden vereinigt, die Naht zwischen ihnen wird geschlossen, und ein weiter Bereich bei aufgeschältem Bauch zeigt den ganzen Dickdarm.</translation>
    </message>
    <message>
        <source>(j) The colon is pulled out beside the scan and coloured by the magnitude of the gradient.</source>
        <translation>(j) Der Dickdarm wird neben den Scan herausgezogen und nach dem Gradientenbetrag gefärbt.</translation>
    </message>
    <message>
        <source>(g) In a high range the other part is seen: stool. The scan is opened section by section, and broad strokes are drawn on what belongs to the colon.</source>
        <translation>(g) In einem hohen Bereich ist der andere Teil zu sehen: Stuhl. Der Scan wird Schnitt für Schnitt geöffnet, und breite Striche werden auf das gezeichnet, was zum Dickdarm gehört.</translation>
    </message>
    <message>
        <source>(h) They grow in the same way for a few generations, until they meet the wall of the colon.</source>
        <translation>(h) Sie wachsen auf dieselbe Weise einige Generationen lang, bis sie auf die Wand des Dickdarms treffen.</translation>
    </message>
    <message>
        <source>(i) Gas and stool are made one, the wall between them is closed, and a wide range with the abdomen peeled open shows the whole colon.</source>
        <translation>(i) Gas und Stuhl werden vereinigt, die Wand zwischen ihnen wird überbrückt, und ein weiter Bereich bei aufgeschältem Bauch zeigt den ganzen Dickdarm.</translation>
    </message>
    <message>
        <source>(a) A wide range of intensities is selected: the whole head as a surface, from the front and from above.</source>
        <translation>(a) Ein weiter Intensitätsbereich wird gewählt: der ganze Kopf als Oberfläche, von vorn und von oben.</translation>
    </message>
    <message>
        <source>(b) The drill is chosen and a tube is drawn in one stroke: once around the head, inwards, and once around its middle. The mask is green while the pen does not press.</source>
        <translation>(b) Der Bohrer wird gewählt und ein Rohr in einem Strich gezeichnet: einmal um den Kopf, nach innen, und einmal um seine Mitte. Die Maske ist grün, solange der Stift nicht drückt.</translation>
    </message>
    <message>
        <source>(c) The pen presses, the mask turns red, and the drill goes down to three quarters of the depth. What then hangs loose is cut with it.</source>
        <translation>(c) Der Stift drückt, die Maske wird rot, und der Bohrer geht bis in drei Viertel der Tiefe hinab. Was danach lose hängt, wird mit weggeschnitten.</translation>
    </message>
    <message>
        <source>(d) A transfer function over the gradient&apos;s magnitude gives edges a light colour and the even inside of tissue a red one. The shell that was cut out is pasted beside what remains.</source>
        <translation>(d) Eine Transferfunktion über dem Gradientenbetrag gibt Kanten eine helle Farbe und dem gleichmäßigen Inneren von Gewebe eine rote. Die ausgeschnittene Schale wird neben dem Verbliebenen eingefügt.</translation>
    </message>
    <message>
        <source>(a) An engine block, displayed as a surface.</source>
        <translation>(a) Ein Motorblock, als Oberfläche angezeigt.</translation>
    </message>
    <message>
        <source>(b) A circle is swept along a helix around the block. All values are displayed to see the swept body whole.</source>
        <translation>(b) Ein Kreis wird entlang einer Helix um den Block ausgetragen. Alle Werte werden angezeigt, damit der ausgetragene Körper ganz zu sehen ist.</translation>
    </message>
    <message>
        <source>(c) The helix is subtracted from the block.</source>
        <translation>(c) Die Helix wird vom Block abgezogen.</translation>
    </message>
    <message>
        <source>(a) The head, displayed as a surface.</source>
        <translation>(a) Der Kopf, als Oberfläche angezeigt.</translation>
    </message>
    <message>
        <source>(b) A circle is swept along a helix around the head. All values are displayed to see the swept body whole.</source>
        <translation>(b) Ein Kreis wird entlang einer Helix um den Kopf ausgetragen. Alle Werte werden angezeigt, damit der ausgetragene Körper ganz zu sehen ist.</translation>
    </message>
    <message>
        <source>(c) The helix is subtracted from the head.</source>
        <translation>(c) Die Helix wird vom Kopf abgezogen.</translation>
    </message>
    <message>
        <source>(a) The whole range of intensities is displayed: the head from its skin inwards.</source>
        <translation>(a) Der ganze Intensitätsbereich wird angezeigt: der Kopf von der Haut an einwärts.</translation>
    </message>
    <message>
        <source>(b) A low range is selected on the histogram, that of fluid. As an X-ray it shows the fluid around the brain, the ventricles and the eyes.</source>
        <translation>(b) Im Histogramm wird ein niedriger Bereich gewählt, jener von Flüssigkeit. Als Röntgenbild zeigt er die Flüssigkeit um das Gehirn, die Ventrikel und die Augen.</translation>
    </message>
    <message>
        <source>(c) As a surface the same range begins at the skin, whose edge passes through it.</source>
        <translation>(c) Als Oberfläche beginnt derselbe Bereich an der Haut, deren Kante ihn durchläuft.</translation>
    </message>
    <message>
        <source>The head is displayed from its skin inwards and a corner of it is clipped away, so that the colours inside are seen too.</source>
        <translation>Der Kopf wird von der Haut an einwärts angezeigt und an einer Ecke beschnitten, damit auch die Farben im Inneren zu sehen sind.</translation>
    </message>
    <message>
        <source>(a) Colours over the histogram of intensities: blue for fluid, red for grey matter and muscle, cream for white matter, yellow for fat.</source>
        <translation>(a) Farben über dem Histogramm der Intensitäten: Blau für Flüssigkeit, Rot für graue Substanz und Muskel, Creme für weiße Substanz, Gelb für Fett.</translation>
    </message>
    <message>
        <source>(b) Colours over the histogram of gradient magnitudes: blue where values are even, green to orange where they change steeply.</source>
        <translation>(b) Farben über dem Histogramm der Gradientenbeträge: Blau, wo die Werte gleichmäßig sind, Grün bis Orange, wo sie sich steil ändern.</translation>
    </message>
    <message>
        <source>(c) Colours over both at once: each even tissue has its own, the skin has its own by its low values and steep edge, and the edges inside are green.</source>
        <translation>(c) Farben über beiden zugleich: Jedes gleichmäßige Gewebe hat seine eigene, die Haut hat ihre eigene durch ihre niedrigen Werte und ihre steile Kante, und die Kanten im Inneren sind grün.</translation>
    </message>
    <message>
        <source>The back of the head, where the skin is even, is looked at.</source>
        <translation>Betrachtet wird der Hinterkopf, wo die Haut gleichmäßig ist.</translation>
    </message>
    <message>
        <source>(a) Drilled along the view: the depth is the greatest depth times the pressure. With a greatest depth of 10 steps, pressures of 0.2, 0.3, 0.5 and 1 make holes of 2, 3, 5 and 10 steps. A slice through them shows it.</source>
        <translation>(a) In Blickrichtung gebohrt: Die Tiefe ist die größte Tiefe, multipliziert mit dem Druck. Bei einer größten Tiefe von 10 Schritten ergeben Drücke von 0.2, 0.3, 0.5 und 1 Löcher von 2, 3, 5 und 10 Schritten. Eine Schicht durch die Löcher zeigt es.</translation>
    </message>
    <message>
        <source>(b) Burned by the laser along the normal of the surface: with a greatest depth of 20 steps, pressures of 0.1, 0.15, 0.25 and 0.5 make the same depths.</source>
        <translation>(b) Mit dem Laser entlang der Oberflächennormale gebrannt: Bei einer größten Tiefe von 20 Schritten ergeben Drücke von 0.1, 0.15, 0.25 und 0.5 dieselben Tiefen.</translation>
    </message>
    <message>
        <source>(c) Peeled: each pixel that the pen is dragged down takes a tenth of a layer off, so 20, 30, 50 and 100 pixels take 2, 3, 5 and 10 layers.</source>
        <translation>(c) Geschält: Jedes Pixel, um das der Stift nach unten gezogen wird, nimmt ein Zehntel einer Lage ab; 20, 30, 50 und 100 Pixel nehmen also 2, 3, 5 und 10 Lagen ab.</translation>
    </message>
    <message>
        <source>(d) What the three tools have removed, seen from the side: drilled above, burned in the middle, peeled below.</source>
        <translation>(d) Was die drei Werkzeuge entfernt haben, von der Seite gesehen: oben gebohrt, in der Mitte gebrannt, unten geschält.</translation>
    </message>
    <message>
        <source>The upper part of the head is clipped away, so that the lateral ventricles are seen in a section. A stroke on each sets the seeds.</source>
        <translation>Der Kopf wird um seinen oberen Teil beschnitten, damit die Seitenventrikel in einer Schnittfläche zu sehen sind. Ein Strich auf jedem setzt die Saat.</translation>
    </message>
    <message>
        <source>(a) Growth stops after some generations. Drawn voxel by voxel, the region shows the corners of its front.</source>
        <translation>(a) Das Wachstum hält nach einigen Generationen an. Voxel für Voxel gezeichnet, zeigt die Region die Ecken ihrer Front.</translation>
    </message>
    <message>
        <source>(b) Each voxel of the region radiates into those around it, and what is drawn is the level of one half: the front&apos;s steps of one voxel are smooth.</source>
        <translation>(b) Jedes Voxel der Region strahlt in die umliegenden, und gezeichnet wird das Niveau von einem Halben: Die Stufen der Front von einem Voxel sind glatt.</translation>
    </message>
    <message>
        <source>(c) Closer: thin ends of one voxel&apos;s width stay, and no voxel shows its corners.</source>
        <translation>(c) Näher: Dünne Enden von einem Voxel Breite bleiben, und kein Voxel zeigt seine Ecken.</translation>
    </message>
    <message>
        <source>(a) A rectangle, with the drill: straight down along the view.</source>
        <translation>(a) Ein Rechteck, mit dem Bohrer: in Blickrichtung gerade hinab.</translation>
    </message>
    <message>
        <source>(b) An ellipse, with the laser: the pen moves over the head with growing pressure, and the laser burns along the surface&apos;s normal.</source>
        <translation>(b) Eine Ellipse, mit dem Laser: Der Stift bewegt sich mit wachsendem Druck über den Kopf, und der Laser brennt entlang der Oberflächennormale.</translation>
    </message>
    <message>
        <source>(c) A polyline, with the peeling tool: a star, twelve layers deep.</source>
        <translation>(c) Ein Linienzug, mit dem Schälwerkzeug: ein Stern, zwölf Lagen tief.</translation>
    </message>
    <message>
        <source>(d) A free-form stroke, with the peeling tool: a heart, to the bone.</source>
        <translation>(d) Ein Freihandstrich, mit dem Schälwerkzeug: ein Herz, bis auf den Knochen.</translation>
    </message>
    <message>
        <source>The scan was made with the pot lying on its side: it is set upright.</source>
        <translation>Bei der Aufnahme lag die Kanne auf der Seite: Der Scan wird aufrecht gestellt.</translation>
    </message>
    <message>
        <source>(a) A rectangle, with the drill: a window through the wall.</source>
        <translation>(a) Ein Rechteck, mit dem Bohrer: ein Fenster durch die Wand.</translation>
    </message>
    <message>
        <source>(b) An ellipse, with the laser: the pen goes down the belly with growing pressure.</source>
        <translation>(b) Eine Ellipse, mit dem Laser: Der Stift fährt mit wachsendem Druck den Bauch hinab.</translation>
    </message>
    <message>
        <source>(c) A polyline, with the peeling tool: a star, two layers deep.</source>
        <translation>(c) Ein Linienzug, mit dem Schälwerkzeug: ein Stern, zwei Lagen tief.</translation>
    </message>
    <message>
        <source>(d) A free-form stroke, with the drill: a heart, through the wall.</source>
        <translation>(d) Ein Freihandstrich, mit dem Bohrer: ein Herz, durch die Wand.</translation>
    </message>
    <message>
        <source>(a) The X-ray of the teapot shows that something is in it.</source>
        <translation>(a) Das Röntgenbild der Teekanne zeigt, dass etwas darin ist.</translation>
    </message>
    <message>
        <source>(b) From above an ellipse is drawn and the pot is drilled open.</source>
        <translation>(b) Von oben wird eine Ellipse gezeichnet und die Kanne aufgebohrt.</translation>
    </message>
    <message>
        <source>(c) Free-form strokes on the lobster set the seeds.</source>
        <translation>(c) Freihandstriche auf dem Hummer setzen die Saat.</translation>
    </message>
    <message>
        <source>(d) The region grows until nothing of the lobster is left to take.</source>
        <translation>(d) Die Region wächst, bis vom Hummer nichts mehr zu nehmen bleibt.</translation>
    </message>
    <message>
        <source>(e) The lobster is pulled out of the pot and enlarged.</source>
        <translation>(e) Der Hummer wird aus der Kanne herausgezogen und vergrößert.</translation>
    </message>
</context>
<context>
    <name>library</name>
    <message>
        <source>view</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>peel</source>
        <translation>Schälen</translation>
    </message>
    <message>
        <source>drill</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>laser</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>Austragen</translation>
    </message>
    <message>
        <source>scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>Beschneiden</translation>
    </message>
    <message>
        <source>keep connected</source>
        <translation>Verbundenes behalten</translation>
    </message>
    <message>
        <source>paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>move part</source>
        <translation>Teil bewegen</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>Säen</translation>
    </message>
    <message>
        <source>grow</source>
        <translation>Wachsen</translation>
    </message>
    <message>
        <source>rewind</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>show generation</source>
        <translation>Generation zeigen</translation>
    </message>
    <message>
        <source>growth rules</source>
        <translation>Wachstumsregeln</translation>
    </message>
    <message>
        <source>absorb</source>
        <translation>Absorbieren</translation>
    </message>
    <message>
        <source>segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>load labels</source>
        <translation>Labels laden</translation>
    </message>
    <message>
        <source>remove segment</source>
        <translation>Segment entfernen</translation>
    </message>
    <message>
        <source>edit segment</source>
        <translation>Segment bearbeiten</translation>
    </message>
    <message>
        <source>brush segment</source>
        <translation>Segment formen</translation>
    </message>
    <message>
        <source>paint segment</source>
        <translation>Segment malen</translation>
    </message>
    <message>
        <source>cut segment</source>
        <translation>Segment schneiden</translation>
    </message>
    <message>
        <source>undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>un-cut</source>
        <translation>Schnitte aufheben</translation>
    </message>
    <message>
        <source>re-seed</source>
        <translation>Neu säen</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>sculpture</source>
        <translation>Skulptur</translation>
    </message>
    <message>
        <source>keep island</source>
        <translation>Insel behalten</translation>
    </message>
    <message>
        <source>drop island</source>
        <translation>Insel verwerfen</translation>
    </message>
    <message>
        <source>keep largest</source>
        <translation>größtes Teil behalten</translation>
    </message>
    <message>
        <source>drop small</source>
        <translation>kleine Teile verwerfen</translation>
    </message>
    <message>
        <source>fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>open</source>
        <translation>öffnen</translation>
    </message>
    <message>
        <source>close</source>
        <translation>schließen</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>glätten</translation>
    </message>
    <message>
        <source>hollow</source>
        <translation>aushöhlen</translation>
    </message>
    <message>
        <source>unite</source>
        <translation>vereinigen</translation>
    </message>
    <message>
        <source>subtract</source>
        <translation>abziehen</translation>
    </message>
    <message>
        <source>intersect</source>
        <translation>schneiden</translation>
    </message>
    <message>
        <source>%1 voxels changed</source>
        <translation>%1 Voxel geändert</translation>
    </message>
    <message>
        <source>%1 voxels added</source>
        <translation>%1 Voxel hinzugefügt</translation>
    </message>
    <message>
        <source>%1 voxels removed</source>
        <translation>%1 Voxel entfernt</translation>
    </message>
    <message>
        <source>%1 voxels seeded</source>
        <translation>%1 Voxel gesät</translation>
    </message>
    <message>
        <source>%1 voxels seeded, %2 refused (outside the grid or the range, cut away, or another segment&apos;s)</source>
        <translation>%1 Voxel gesät, %2 abgelehnt (außerhalb von Gitter oder Bereich, weggeschnitten oder in einem anderen Segment)</translation>
    </message>
    <message>
        <source>%1 voxels absorbed in %2 expansions</source>
        <translation>%1 Voxel in %2 Ausdehnungen absorbiert</translation>
    </message>
    <message>
        <source>%1 voxels, %2 ml; %3 before</source>
        <translation>%1 Voxel, %2 ml; vorher %3</translation>
    </message>
    <message>
        <source>%1 generation; %2 voxels, %3 ml</source>
        <translation>%1 Generation; %2 Voxel, %3 ml</translation>
    </message>
    <message>
        <source>%1 generations; %2 voxels, %3 ml</source>
        <translation>%1 Generationen; %2 Voxel, %3 ml</translation>
    </message>
    <message>
        <source>%1 generation back; %2 voxels, %3 ml</source>
        <translation>%1 Generation zurück; %2 Voxel, %3 ml</translation>
    </message>
    <message>
        <source>%1 generations back; %2 voxels, %3 ml</source>
        <translation>%1 Generationen zurück; %2 Voxel, %3 ml</translation>
    </message>
    <message>
        <source>growing in %1 to %2; %3 voxels</source>
        <translation>wächst in %1 bis %2; %3 Voxel</translation>
    </message>
    <message>
        <source>%1 segment, %2 voxels</source>
        <translation>%1 Segment, %2 Voxel</translation>
    </message>
    <message>
        <source>%1 segments, %2 voxels</source>
        <translation>%1 Segmente, %2 Voxel</translation>
    </message>
    <message>
        <source>at work on %1</source>
        <translation>arbeitet an %1</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>%1 geändert</translation>
    </message>
    <message>
        <source>all cuts cleared</source>
        <translation>alle Schnitte aufgehoben</translation>
    </message>
    <message>
        <source>segmentation cleared</source>
        <translation>Segmentierung geleert</translation>
    </message>
    <message>
        <source>nothing was cut: nothing visible lies there that was not cut already</source>
        <translation>nichts wurde geschnitten: dort liegt nichts Sichtbares, das nicht schon geschnitten war</translation>
    </message>
    <message>
        <source>nothing was restored: nothing was cut away there</source>
        <translation>nichts wurde aufgefüllt: dort war nichts weggeschnitten</translation>
    </message>
    <message>
        <source>nothing seeded: no voxel in range lies under the stroke</source>
        <translation>nichts gesät: unter dem Strich liegt kein Voxel im Bereich</translation>
    </message>
    <message>
        <source>nothing absorbed: the stroke does not lie on the segment</source>
        <translation>nichts absorbiert: der Strich liegt nicht auf dem Segment</translation>
    </message>
    <message>
        <source>nothing changed: no voxel lies under the brush</source>
        <translation>nichts geändert: unter dem Pinsel liegt kein Voxel</translation>
    </message>
    <message>
        <source>nothing changed: no voxel under the brush could be added or removed</source>
        <translation>nichts geändert: unter dem Pinsel ließ sich kein Voxel hinzufügen oder entfernen</translation>
    </message>
    <message>
        <source>nothing changed: the stroke does not reach the segment&apos;s surface</source>
        <translation>nichts geändert: der Strich reicht nicht an die Oberfläche des Segments</translation>
    </message>
    <message>
        <source>CT bone</source>
        <translation>CT-Knochen</translation>
    </message>
    <message>
        <source>Skeleton alone; Hounsfield units</source>
        <translation>Nur das Skelett; Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>CT bone, surfaces</source>
        <translation>CT-Knochen, Oberflächen</translation>
    </message>
    <message>
        <source>Bone&apos;s surface by its steep edge, marrow faint inside; Hounsfield units</source>
        <translation>Knochenoberfläche an ihrer steilen Kante, Mark zart darin; Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>CT skin</source>
        <translation>CT-Haut</translation>
    </message>
    <message>
        <source>The skin&apos;s surface, opaque; Hounsfield units</source>
        <translation>Die Oberfläche der Haut, deckend; Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>CT skin, muscle and bone</source>
        <translation>CT-Haut, Muskel, Knochen</translation>
    </message>
    <message>
        <source>Skin as a thin veil, muscle and bone by their edges; Hounsfield units</source>
        <translation>Haut als dünner Schleier, Muskel und Knochen an ihren Kanten; Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>CT soft tissue</source>
        <translation>CT-Weichteile</translation>
    </message>
    <message>
        <source>Muscle and organs, a veil of fat, bone behind; Hounsfield units</source>
        <translation>Muskeln und Organe, ein Schleier aus Fett, Knochen dahinter; Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>CT vessels</source>
        <translation>CT-Gefäße</translation>
    </message>
    <message>
        <source>Vessels filled with contrast medium, bone as a pale shell; Hounsfield units</source>
        <translation>Gefäße mit Kontrastmittel, Knochen als blasse Schale; Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Boundaries of any kind: the steeper, the denser; follows the gradients</source>
        <translation>Grenzen aller Art: je steiler, desto dichter; folgt den Gradienten</translation>
    </message>
    <message>
        <source>Grey ramp</source>
        <translation>Graurampe</translation>
    </message>
    <message>
        <source>Microscopy</source>
        <translation>Mikroskopie</translation>
    </message>
    <message>
        <source>Fluorescence: bright is dense and glows; follows the histogram</source>
        <translation>Fluoreszenz: Helles ist dicht und leuchtet; folgt dem Histogramm</translation>
    </message>
    <message>
        <source>MR angiography</source>
        <translation>MR-Angiographie</translation>
    </message>
    <message>
        <source>Bright vessels from time-of-flight or contrast MR; follows the histogram</source>
        <translation>Helle Gefäße aus Time-of-Flight- oder Kontrast-MR; folgt dem Histogramm</translation>
    </message>
    <message>
        <source>MR T1, skin and brain</source>
        <translation>MR T1, Haut und Hirn</translation>
    </message>
    <message>
        <source>Skin as a veil by its edge, grey and white matter by their values; follows the histogram</source>
        <translation>Haut als Schleier an ihrer Kante, graue und weiße Substanz nach ihren Werten; folgt dem Histogramm</translation>
    </message>
    <message>
        <source>MR T1 head</source>
        <translation>MR T1, Kopf</translation>
    </message>
    <message>
        <source>Head from T1-weighted MR, nearly opaque: a cut shows grey and white matter; follows the histogram</source>
        <translation>Kopf aus T1-gewichtetem MR, fast deckend: ein Schnitt zeigt graue und weiße Substanz; folgt dem Histogramm</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>black to white</source>
        <translation>Schwarz bis Weiß</translation>
    </message>
    <message>
        <source>ivory</source>
        <translation>Elfenbein</translation>
    </message>
    <message>
        <source>bone: umber shadows to ivory</source>
        <translation>Knochen: umbrabraune Schatten bis Elfenbein</translation>
    </message>
    <message>
        <source>ember</source>
        <translation>Glut</translation>
    </message>
    <message>
        <source>night, embers, flame</source>
        <translation>Nacht, Glut, Flamme</translation>
    </message>
    <message>
        <source>marine</source>
        <translation>Meer</translation>
    </message>
    <message>
        <source>deep sea to foam</source>
        <translation>Tiefsee bis Gischt</translation>
    </message>
    <message>
        <source>flesh</source>
        <translation>Fleisch</translation>
    </message>
    <message>
        <source>muscle to pale skin</source>
        <translation>Muskel bis helle Haut</translation>
    </message>
    <message>
        <source>vessel</source>
        <translation>Gefäß</translation>
    </message>
    <message>
        <source>dark blood to bright blood</source>
        <translation>dunkles bis helles Blut</translation>
    </message>
    <message>
        <source>tide</source>
        <translation>Gezeiten</translation>
    </message>
    <message>
        <source>blue below, orange above, pale in the middle</source>
        <translation>unten blau, oben orange, in der Mitte blass</translation>
    </message>
    <message>
        <source>A head, magnetic resonance</source>
        <translation>Ein Kopf, Magnetresonanz</translation>
    </message>
    <message>
        <source>The same head, sharper</source>
        <translation>Derselbe Kopf, schärfer</translation>
    </message>
    <message>
        <source>Its brain alone</source>
        <translation>Nur sein Gehirn</translation>
    </message>
    <message>
        <source>A macaque&apos;s brain</source>
        <translation>Das Gehirn eines Makaken</translation>
    </message>
    <message>
        <source>part %1</source>
        <translation>Teil %1</translation>
    </message>
    <message>
        <source>restore</source>
        <translation>auffüllen</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>one generation</source>
        <translation>eine Generation</translation>
    </message>
    <message>
        <source>%1 generations</source>
        <translation>%1 Generationen</translation>
    </message>
    <message>
        <source>%1 layers</source>
        <translation>%1 Lagen</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>to the end</source>
        <translation>bis zum Ende</translation>
    </message>
    <message>
        <source>add</source>
        <translation>hinzufügen</translation>
    </message>
    <message>
        <source>remove</source>
        <translation>entfernen</translation>
    </message>
    <message>
        <source>all but it</source>
        <translation>alles andere</translation>
    </message>
    <message>
        <source>away</source>
        <translation>weg</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>only %1 is shown</source>
        <translation>nur %1 wird gezeigt</translation>
    </message>
    <message>
        <source>all segments are shown</source>
        <translation>alle Segmente werden gezeigt</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>show segments</source>
        <translation>Segmente zeigen</translation>
    </message>
    <message>
        <source>nothing has changed: what lies there is spared, or was as it would be</source>
        <translation>nichts hat sich geändert: was dort liegt, wird verschont oder war schon so</translation>
    </message>
    <message>
        <source>nothing has changed: the voxels lie there already</source>
        <translation>nichts hat sich geändert: die Voxel liegen schon so</translation>
    </message>
    <message>
        <source>%1, the mirror image of what the file says</source>
        <translation>%1, das Spiegelbild dessen, was die Datei sagt</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Every value above air, evenly: grey and opacity rise together; follows the histogram</source>
        <translation>Alle Werte über Luft gleichmäßig: Grau und Deckkraft steigen gemeinsam; folgt dem Histogramm</translation>
    </message>
    <message>
        <source>pull out</source>
        <translation>herausziehen</translation>
    </message>
    <message>
        <source>put back</source>
        <translation>zurücklegen</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>discard part</source>
        <translation>Teil verwerfen</translation>
    </message>
    <message>
        <source>measure</source>
        <translation>messen</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>remove measurement</source>
        <translation>Messung löschen</translation>
    </message>
    <message>
        <source>movie</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>nothing was erased: nothing is marked there</source>
        <translation>nichts wurde gelöscht: Dort ist nichts markiert</translation>
    </message>
    <message>
        <source>nothing was marked: nothing visible lies there</source>
        <translation>nichts wurde markiert: Dort liegt nichts Sichtbares</translation>
    </message>
    <message>
        <source>erase</source>
        <translation>löschen</translation>
    </message>
    <message>
        <source>%1 mm wide</source>
        <translation>%1 mm breit</translation>
    </message>
    <message>
        <source>mark</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>remove marks</source>
        <translation>Markierungen entfernen</translation>
    </message>
    <message>
        <source>marks</source>
        <translation>Markierungen schreiben</translation>
    </message>
    <message>
        <source>nothing was filled: no surface is seen there</source>
        <translation>nichts gefüllt: dort ist keine Oberfläche zu sehen</translation>
    </message>
    <message>
        <source>nothing was taken away: nothing is filled there</source>
        <translation>nichts weggenommen: dort ist nichts gefüllt</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>Nummer %1</translation>
    </message>
    <message>
        <source>material %1</source>
        <translation>Material %1</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>fill</source>
        <translation>füllen</translation>
    </message>
    <message>
        <source>fill hole</source>
        <translation>Loch füllen</translation>
    </message>
    <message>
        <source>unfill</source>
        <translation>Füllung wegnehmen</translation>
    </message>
    <message>
        <source>remove fill</source>
        <translation>Füllung entfernen</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>Gefülltes</translation>
    </message>
    <message>
        <source>material surface</source>
        <translation>Oberfläche des Materials</translation>
    </message>
    <message>
        <source>segment material</source>
        <translation>Material segmentieren</translation>
    </message>
</context>
<context>
    <name>vs::desktop</name>
    <message>
        <source>Face of the clip box, in voxels from the grid&apos;s border</source>
        <translation>Fläche des Schnittquaders, in Voxeln vom Rand des Gitters</translation>
    </message>
    <message>
        <source>Face the viewer</source>
        <translation>Zum Betrachter</translation>
    </message>
    <message>
        <source>A clip plane that faces the viewer</source>
        <translation>Eine Schnittebene, die zum Betrachter zeigt</translation>
    </message>
    <message>
        <source>Clips before a plane across the view; turn the volume and press again to turn it along</source>
        <translation>Schneidet vor einer Ebene quer zur Blickrichtung; Volumen drehen und noch einmal drücken, um sie mitzudrehen</translation>
    </message>
    <message>
        <source>No plane</source>
        <translation>Keine Ebene</translation>
    </message>
    <message>
        <source>No clip plane</source>
        <translation>Keine Schnittebene</translation>
    </message>
    <message>
        <source>Place of the clip plane before the centre, in mm</source>
        <translation>Lage der Schnittebene vor der Mitte, in mm</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Außen</translation>
    </message>
    <message>
        <source>What is outside the box, or before the plane, goes</source>
        <translation>Was außerhalb des Quaders oder vor der Ebene liegt, fällt weg</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>What is inside goes instead</source>
        <translation>Stattdessen fällt weg, was innen liegt</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Nimmt weg</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>The whole grid again, no plane</source>
        <translation>Wieder das ganze Gitter, ohne Ebene</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Signed difference of intensity from a voxel to the next: new minus old</source>
        <translation>Intensitätsunterschied von einem Voxel zum nächsten, mit Vorzeichen: neu minus alt</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>Magnitude of the gradient, in intensity per mm</source>
        <translation>Betrag des Gradienten, in Intensität je mm</translation>
    </message>
    <message>
        <source>Gradient diff.</source>
        <translation>Gradientendiff.</translation>
    </message>
    <message>
        <source>Signed difference of the gradient&apos;s magnitude from a voxel to the next</source>
        <translation>Unterschied des Gradientenbetrags von einem Voxel zum nächsten, mit Vorzeichen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Between two places, in mm</source>
        <translation>Zwischen zwei Stellen, in mm</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>At the second of three places, in degrees</source>
        <translation>An der zweiten von drei Stellen, in Grad</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Was gemessen wurde</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Delete last</source>
        <translation>Letzte löschen</translation>
    </message>
    <message>
        <source>Delete the last measurement</source>
        <translation>Die letzte Messung löschen</translation>
    </message>
    <message>
        <source>Delete all</source>
        <translation>Alle löschen</translation>
    </message>
    <message>
        <source>Delete all measurements</source>
        <translation>Alle Messungen löschen</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Reshape a 3D scan with a pen, on the rendered picture itself.</source>
        <translation>Formt einen 3D-Scan mit dem Stift um, auf dem gerenderten Bild selbst.</translation>
    </message>
    <message>
        <source>Volume to open (a file or a DICOM folder), or a session (.json).</source>
        <translation>Zu öffnendes Volumen (eine Datei oder ein DICOM-Ordner) oder eine Sitzung (.json).</translation>
    </message>
    <message>
        <source>Session to open and replay; FILE, if given, replaces its volume.</source>
        <translation>Zu öffnende und nachzuspielende Sitzung; FILE ersetzt, falls angegeben, deren Volumen.</translation>
    </message>
    <message>
        <source>FILE has no header: DIMS:TYPE[:SPACING[:OFFSET]].</source>
        <translation>FILE hat keinen Dateikopf: DIMS:TYPE[:SPACING[:OFFSET]].</translation>
    </message>
    <message>
        <source>Which DICOM series of a folder: its UID or its number.</source>
        <translation>Welche DICOM-Serie eines Ordners: ihre UID oder ihre Nummer.</translation>
    </message>
    <message>
        <source>Which volume of a 4D file, counted from 0.</source>
        <translation>Welches Volumen einer 4D-Datei, gezählt ab 0.</translation>
    </message>
    <message>
        <source>For tests and automation: keep PATH up to date with a JSON object of the program&apos;s state (&quot;idle&quot;, &quot;tool&quot;, &quot;mode&quot;, &quot;generation&quot;, &quot;voxels&quot;, &quot;operations&quot;, &quot;message&quot;, &quot;pictureComplete&quot; ...) and the rectangle [x, y, width, height] of the picture (&quot;viewRect&quot;) and of each named button and field (&quot;widgets&quot;) in pixels of the screen. It is replaced as a whole whenever something changes.</source>
        <translation>Für Tests und Automatisierung: PATH als JSON-Objekt mit dem Zustand des Programms auf dem neuesten Stand halten (&quot;idle&quot;, &quot;tool&quot;, &quot;mode&quot;, &quot;generation&quot;, &quot;voxels&quot;, &quot;operations&quot;, &quot;message&quot;, &quot;pictureComplete&quot; ...), dazu das Rechteck [x, y, Breite, Höhe] des Bildes (&quot;viewRect&quot;) und jedes benannten Knopfes und Feldes (&quot;widgets&quot;) in Bildschirmpixeln. Es wird bei jeder Änderung als Ganzes ersetzt.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>What is painted joins the segment at work</source>
        <translation>Was bemalt wird, kommt zum aktiven Segment</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>What is painted leaves it</source>
        <translation>Was bemalt wird, fällt heraus</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>Paints on the slice that is drawn on alone</source>
        <translation>Malt nur auf der Schicht, auf der gezeichnet wird</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Reaches into the slices around it, as far as it is wide</source>
        <translation>Reicht so weit in die Nachbarschichten, wie sie breit ist</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Radius of the brush, in mm</source>
        <translation>Radius des Pinsels, in mm</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Only in range</source>
        <translation>Nur im Bereich</translation>
    </message>
    <message>
        <source>Leaves voxels alone whose intensity growth would refuse</source>
        <translation>Lässt Voxel aus, deren Intensität das Wachstum nicht zuließe</translation>
    </message>
    <message>
        <source>A session to replay</source>
        <translation>Eine Sitzung zum Nachspielen</translation>
    </message>
    <message>
        <source>Made from nothing</source>
        <translation>Aus dem Nichts gemacht</translation>
    </message>
    <message>
        <source>Grow or shrink by a margin</source>
        <translation>Rand zugeben oder nehmen</translation>
    </message>
    <message>
        <source>Grows by so much all around; below zero it shrinks.</source>
        <translation>Wächst ringsum um so viel; unter null schrumpft es.</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Rounds what is rougher than this.</source>
        <translation>Rundet, was rauer ist als dies.</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>Fills what is enclosed, up to this size; 0 fills all.</source>
        <translation>Füllt Eingeschlossenes bis zu dieser Größe; 0 füllt alles.</translation>
    </message>
    <message>
        <source>Open: cut thin bridges</source>
        <translation>Öffnen: Brücken kappen</translation>
    </message>
    <message>
        <source>Shrinks, then grows: what is thinner than twice this goes.</source>
        <translation>Schrumpft, dann wächst es: was dünner ist als das Doppelte, fällt weg.</translation>
    </message>
    <message>
        <source>Close: bridge gaps</source>
        <translation>Schließen: Lücken füllen</translation>
    </message>
    <message>
        <source>Grows, then shrinks: gaps narrower than twice this are filled.</source>
        <translation>Wächst, dann schrumpft es: Lücken, enger als das Doppelte, werden gefüllt.</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Aushöhlen</translation>
    </message>
    <message>
        <source>Leaves a wall of this thickness inside the surface.</source>
        <translation>Lässt unter der Oberfläche eine Wand dieser Dicke.</translation>
    </message>
    <message>
        <source>Drop or keep the part clicked</source>
        <translation>Angeklicktes Teil wählen</translation>
    </message>
    <message>
        <source>Click parts in the picture: each is dropped or, with R, kept alone.</source>
        <translation>Teile im Bild anklicken: jedes fällt weg oder bleibt, mit R, als einziges.</translation>
    </message>
    <message>
        <source>Keep the largest part</source>
        <translation>Größtes Teil behalten</translation>
    </message>
    <message>
        <source>Drops all parts that are not connected to the largest.</source>
        <translation>Verwirft alle Teile, die nicht mit dem größten verbunden sind.</translation>
    </message>
    <message>
        <source>Drop small parts</source>
        <translation>Kleine Teile verwerfen</translation>
    </message>
    <message>
        <source>Drops connected parts smaller than this.</source>
        <translation>Verwirft verbundene Teile, die kleiner sind als dies.</translation>
    </message>
    <message>
        <source>Unite with another</source>
        <translation>Mit anderem vereinigen</translation>
    </message>
    <message>
        <source>Takes in all of the other, which is left empty.</source>
        <translation>Nimmt das andere ganz auf, das leer zurückbleibt.</translation>
    </message>
    <message>
        <source>Subtract another</source>
        <translation>Anderes abziehen</translation>
    </message>
    <message>
        <source>Takes away what lies within this distance of the other.</source>
        <translation>Nimmt weg, was näher als dieser Abstand am anderen liegt.</translation>
    </message>
    <message>
        <source>Intersect with another</source>
        <translation>Mit anderem schneiden</translation>
    </message>
    <message>
        <source>Keeps only what lies within this distance of the other.</source>
        <translation>Behält nur, was näher als dieser Abstand am anderen liegt.</translation>
    </message>
    <message>
        <source>Cut it away from the scan</source>
        <translation>Aus dem Scan ausschneiden</translation>
    </message>
    <message>
        <source>Cuts the segment out of the scan, with this margin around it.</source>
        <translation>Schneidet das Segment mit diesem Rand aus dem Scan heraus.</translation>
    </message>
    <message>
        <source>Cut away all but it</source>
        <translation>Alles andere wegschneiden</translation>
    </message>
    <message>
        <source>Cuts everything else away, but for this margin around it.</source>
        <translation>Schneidet bis auf diesen Rand alles andere weg.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Säen</translation>
    </message>
    <message>
        <source>Strokes are what the segment grows from (R)</source>
        <translation>Aus den Strichen wächst das Segment (R)</translation>
    </message>
    <message>
        <source>Absorb</source>
        <translation>Absorbieren</translation>
    </message>
    <message>
        <source>Strokes take the segment away, from there outward (R)</source>
        <translation>Striche nehmen das Segment weg, von dort nach außen (R)</translation>
    </message>
    <message>
        <source>Width of the seed stroke, in pixels</source>
        <translation>Breite des Saatstrichs, in Pixeln</translation>
    </message>
    <message>
        <source>Stroke width</source>
        <translation>Strichbreite</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>What is connected to the place clicked goes (R)</source>
        <translation>Was mit der angeklickten Stelle verbunden ist, fällt weg (R)</translation>
    </message>
    <message>
        <source>Keep only</source>
        <translation>Nur behalten</translation>
    </message>
    <message>
        <source>What is not connected to the place clicked goes (R)</source>
        <translation>Was nicht mit der angeklickten Stelle verbunden ist, fällt weg (R)</translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation>Bild verschieben</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Mittlere Taste</translation>
    </message>
    <message>
        <source>Shift+Drag</source>
        <translation>Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>Rechte Taste</translation>
    </message>
    <message>
        <source>Do what is prepared</source>
        <translation>Vorbereitetes ausführen</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Restore while it is held</source>
        <translation>Auffüllen, solange gehalten</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>heute %1</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>gestern</translation>
    </message>
    <message>
        <source>On the surface</source>
        <translation>Auf der Oberfläche</translation>
    </message>
    <message>
        <source>Draw the way on the surface</source>
        <translation>Den Weg auf die Oberfläche zeichnen</translation>
    </message>
    <message>
        <source>Across the view</source>
        <translation>Quer zum Blick</translation>
    </message>
    <message>
        <source>Draw the way in the plane across the view</source>
        <translation>Den Weg in der Ebene quer zum Blick zeichnen</translation>
    </message>
    <message>
        <source>Line inward</source>
        <translation>Gerade hinein</translation>
    </message>
    <message>
        <source>Straight along the view, through the shape</source>
        <translation>Gerade in Blickrichtung durch die Form</translation>
    </message>
    <message>
        <source>Helix inward</source>
        <translation>Helix hinein</translation>
    </message>
    <message>
        <source>A helix along the view, about the shape</source>
        <translation>Eine Helix in Blickrichtung um die Form</translation>
    </message>
    <message>
        <source>How far inward, in steps</source>
        <translation>Wie weit hinein, in Schritten</translation>
    </message>
    <message>
        <source>In steps</source>
        <translation>In Schritten</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Windungen</translation>
    </message>
    <message>
        <source>From end to end</source>
        <translation>Von Anfang bis Ende</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>The shape turns as little as it can along its way</source>
        <translation>Die Form dreht sich auf ihrem Weg so wenig wie möglich</translation>
    </message>
    <message>
        <source>Frenet</source>
        <translation>Frenet</translation>
    </message>
    <message>
        <source>The shape turns with the way&apos;s bends</source>
        <translation>Die Form dreht sich mit den Biegungen des Wegs</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>At once when the pen is lifted</source>
        <translation>Gleich beim Abheben des Stifts</translation>
    </message>
    <message>
        <source>Instead of showing the way first</source>
        <translation>Statt den Weg zuerst zu zeigen</translation>
    </message>
    <message>
        <source>Sweep what is shown</source>
        <translation>Gezeigtes austragen</translation>
    </message>
    <message>
        <source>Restore what is shown (Enter)</source>
        <translation>Gezeigtes auffüllen (Eingabe)</translation>
    </message>
    <message>
        <source>Cut what is shown (Enter)</source>
        <translation>Gezeigtes schneiden (Eingabe)</translation>
    </message>
    <message>
        <source>Depth at full pressure, in steps</source>
        <translation>Tiefe bei vollem Druck, in Schritten</translation>
    </message>
    <message>
        <source>Keep digging</source>
        <translation>Weitergraben</translation>
    </message>
    <message>
        <source>Goes deeper as long as the pen moves, instead of down to the depth</source>
        <translation>Geht tiefer, solange sich der Stift bewegt, statt nur bis zur Tiefe</translation>
    </message>
    <message>
        <source>Layers peeled</source>
        <translation>Geschälte Lagen</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>10 pixels of dragging are one layer; a layer is the smallest voxel spacing.</source>
        <translation>10 Pixel Ziehen sind eine Lage; eine Lage ist der kleinste Voxelabstand.</translation>
    </message>
    <message>
        <source>Follow the pen&apos;s tilt</source>
        <translation>Der Neigung des Stifts folgen</translation>
    </message>
    <message>
        <source>Drills the way that the tablet&apos;s pen points, instead of along the view</source>
        <translation>Bohrt dorthin, wohin der Stift des Tabletts zeigt, statt in Blickrichtung</translation>
    </message>
    <message>
        <source>Pressure of the mouse, in percent</source>
        <translation>Druck der Maus, in Prozent</translation>
    </message>
    <message>
        <source>How hard the mouse presses; a tablet&apos;s pen reports its own pressure</source>
        <translation>Wie stark die Maus drückt; der Stift eines Tabletts meldet seinen eigenen Druck</translation>
    </message>
    <message>
        <source>Mouse pressure</source>
        <translation>Mausdruck</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Press and hold presses harder</source>
        <translation>Halten drückt fester</translation>
    </message>
    <message>
        <source>A mouse that is held down goes from a light touch to full pressure in a second</source>
        <translation>Eine gehaltene Maustaste geht in einer Sekunde von leichter Berührung zu vollem Druck</translation>
    </message>
    <message>
        <source>Pressure of the tablet&apos;s pen</source>
        <translation>Druck des Tablettstifts</translation>
    </message>
    <message>
        <source>no tablet pen yet</source>
        <translation>noch kein Tablettstift</translation>
    </message>
    <message>
        <source>Pen pressure</source>
        <translation>Stiftdruck</translation>
    </message>
    <message>
        <source>What is inside the stroke goes</source>
        <translation>Was im Strich liegt, fällt weg</translation>
    </message>
    <message>
        <source>What is outside the stroke goes</source>
        <translation>Was außerhalb des Strichs liegt, fällt weg</translation>
    </message>
    <message>
        <source>Of the stroke</source>
        <translation>Vom Strich</translation>
    </message>
    <message>
        <source>Only down to a depth</source>
        <translation>Nur bis in eine Tiefe</translation>
    </message>
    <message>
        <source>Not through everything, but so many steps below the surface</source>
        <translation>Nicht durch alles, sondern nur so viele Schritte unter die Oberfläche</translation>
    </message>
    <message>
        <source>Depth below the surface, in steps</source>
        <translation>Tiefe unter der Oberfläche, in Schritten</translation>
    </message>
    <message>
        <source>Corners too</source>
        <translation>Auch Ecken</translation>
    </message>
    <message>
        <source>Voxels that touch at an edge or a corner are connected</source>
        <translation>Voxel, die sich an Kante oder Ecke berühren, sind verbunden</translation>
    </message>
    <message>
        <source>Faces only</source>
        <translation>Nur Flächen</translation>
    </message>
    <message>
        <source>Only voxels that share a face are connected: keeps less</source>
        <translation>Nur Voxel mit gemeinsamer Fläche sind verbunden: behält weniger</translation>
    </message>
    <message>
        <source>Connected by</source>
        <translation>Verbunden</translation>
    </message>
    <message>
        <source>What is visible follows the displayed range: raise its lower end where a table touches the patient.</source>
        <translation>Was sichtbar ist, folgt dem angezeigten Bereich: sein unteres Ende anheben, wo ein Tisch den Patienten berührt.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Turn the picture</source>
        <translation>Bild drehen</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Roll the picture</source>
        <translation>Bild rollen</translation>
    </message>
    <message>
        <source>Ctrl+Left, Right</source>
        <translation>Strg+Links, Rechts</translation>
    </message>
    <message>
        <source>+  -</source>
        <translation>+  -</translation>
    </message>
    <message>
        <source>Shift+Arrow keys</source>
        <translation>Umschalt+Pfeiltasten</translation>
    </message>
    <message>
        <source>One finger</source>
        <translation>Ein Finger</translation>
    </message>
    <message>
        <source>Move, zoom and roll</source>
        <translation>Verschieben, zoomen, rollen</translation>
    </message>
    <message>
        <source>Two fingers</source>
        <translation>Zwei Finger</translation>
    </message>
    <message>
        <source>The tool turned round</source>
        <translation>Werkzeug umgekehrt</translation>
    </message>
    <message>
        <source>Eraser of the pen</source>
        <translation>Radierer des Stifts</translation>
    </message>
    <message>
        <source>Whatever the tool</source>
        <translation>Bei jedem Werkzeug</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>CSV-Tabelle</translation>
    </message>
    <message>
        <source>Volumes, intensities, surfaces and places, a row each</source>
        <translation>Volumen, Intensitäten, Oberflächen und Orte, je eine Zeile</translation>
    </message>
    <message>
        <source>STL surface</source>
        <translation>STL-Oberfläche</translation>
    </message>
    <message>
        <source>For 3D printing; all in one, without colours</source>
        <translation>Zum 3D-Druck; alles in einem, ohne Farben</translation>
    </message>
    <message>
        <source>glTF surface</source>
        <translation>glTF-Oberfläche</translation>
    </message>
    <message>
        <source>For viewers, the web and Blender; objects with their colours</source>
        <translation>Für Betrachter, das Web und Blender; Objekte mit ihren Farben</translation>
    </message>
    <message>
        <source>PLY surface</source>
        <translation>PLY-Oberfläche</translation>
    </message>
    <message>
        <source>All in one, in colour</source>
        <translation>Alles in einem, in Farbe</translation>
    </message>
    <message>
        <source>OBJ surface</source>
        <translation>OBJ-Oberfläche</translation>
    </message>
    <message>
        <source>Objects with their colours, for modelling programs</source>
        <translation>Objekte mit ihren Farben, für Modellierprogramme</translation>
    </message>
    <message>
        <source>DICOM segmentation</source>
        <translation>DICOM-Segmentierung</translation>
    </message>
    <message>
        <source>For clinical viewers and archives</source>
        <translation>Für klinische Betrachter und Archive</translation>
    </message>
    <message>
        <source>NRRD label map</source>
        <translation>NRRD-Labelkarte</translation>
    </message>
    <message>
        <source>NRRD volume</source>
        <translation>NRRD-Volumen</translation>
    </message>
    <message>
        <source>A number for each segment</source>
        <translation>Eine Zahl je Segment</translation>
    </message>
    <message>
        <source>The values, in their own type</source>
        <translation>Die Werte, in ihrem eigenen Typ</translation>
    </message>
    <message>
        <source>NIfTI label map</source>
        <translation>NIfTI-Labelkarte</translation>
    </message>
    <message>
        <source>NIfTI volume</source>
        <translation>NIfTI-Volumen</translation>
    </message>
    <message>
        <source>When the program ends, write to PATH as JSON when each input arrived and was handled and shown (&quot;inputs&quot;), when each picture was shown (&quot;frames&quot;) and what kept the window from anything else for more than 40 ms (&quot;blocks&quot;), in milliseconds.</source>
        <translation>Beim Beenden als JSON nach PATH schreiben, wann jede Eingabe ankam, bearbeitet und gezeigt wurde („inputs“), wann welches Bild gezeigt wurde („frames“) und was das Fenster länger als 40 ms von allem anderen abhielt („blocks“), in Millisekunden.</translation>
    </message>
    <message>
        <source>Let go to close the mask.</source>
        <translation>Loslassen schließt die Maske.</translation>
    </message>
    <message>
        <source>Enter, a double click or a click on the first corner closes the mask.</source>
        <translation>Enter, ein Doppelklick oder ein Klick auf die erste Ecke schließt die Maske.</translation>
    </message>
    <message>
        <source>Click the first corner to close the mask.</source>
        <translation>Ein Klick auf die erste Ecke schließt die Maske.</translation>
    </message>
    <message>
        <source>Let go to cut.</source>
        <translation>Loslassen schneidet.</translation>
    </message>
    <message>
        <source>Enter, a double click or a click on the first corner cuts.</source>
        <translation>Enter, ein Doppelklick oder ein Klick auf die erste Ecke schneidet.</translation>
    </message>
    <message>
        <source>Click the first corner to cut.</source>
        <translation>Ein Klick auf die erste Ecke schneidet.</translation>
    </message>
    <message>
        <source>Let go to put it back.</source>
        <translation>Loslassen füllt auf.</translation>
    </message>
    <message>
        <source>Enter, a double click or a click on the first corner puts it back.</source>
        <translation>Enter, ein Doppelklick oder ein Klick auf die erste Ecke füllt auf.</translation>
    </message>
    <message>
        <source>Click the first corner to put it back.</source>
        <translation>Ein Klick auf die erste Ecke füllt auf.</translation>
    </message>
    <message>
        <source>Let go to remove it.</source>
        <translation>Loslassen entfernt es.</translation>
    </message>
    <message>
        <source>Enter, a double click or a click on the first corner removes it.</source>
        <translation>Enter, ein Doppelklick oder ein Klick auf die erste Ecke entfernt es.</translation>
    </message>
    <message>
        <source>Click the first corner to remove it.</source>
        <translation>Ein Klick auf die erste Ecke entfernt es.</translation>
    </message>
    <message>
        <source>Let go to add it.</source>
        <translation>Loslassen fügt es hinzu.</translation>
    </message>
    <message>
        <source>Enter, a double click or a click on the first corner adds it.</source>
        <translation>Enter, ein Doppelklick oder ein Klick auf die erste Ecke fügt es hinzu.</translation>
    </message>
    <message>
        <source>Click the first corner to add it.</source>
        <translation>Ein Klick auf die erste Ecke fügt es hinzu.</translation>
    </message>
    <message>
        <source>Let go to place the seeds.</source>
        <translation>Loslassen setzt die Saat.</translation>
    </message>
    <message>
        <source>Enter or a double click places the seeds.</source>
        <translation>Enter oder ein Doppelklick setzt die Saat.</translation>
    </message>
    <message>
        <source>Click the first corner to close the line and place the seeds.</source>
        <translation>Ein Klick auf die erste Ecke schließt die Linie und setzt die Saat.</translation>
    </message>
    <message>
        <source>Let go to absorb from here.</source>
        <translation>Loslassen absorbiert von hier an.</translation>
    </message>
    <message>
        <source>Enter or a double click absorbs from here.</source>
        <translation>Enter oder ein Doppelklick absorbiert von hier an.</translation>
    </message>
    <message>
        <source>Click the first corner to close the line and absorb from here.</source>
        <translation>Ein Klick auf die erste Ecke schließt die Linie und absorbiert von hier an.</translation>
    </message>
    <message>
        <source>Click the second corner.</source>
        <translation>Die zweite Ecke anklicken.</translation>
    </message>
    <message>
        <source>Click the third corner.</source>
        <translation>Die dritte Ecke anklicken.</translation>
    </message>
    <message>
        <source>Click the next corner.</source>
        <translation>Die nächste Ecke anklicken.</translation>
    </message>
    <message>
        <source>Let go to set a corner here.</source>
        <translation>Loslassen setzt hier eine Ecke.</translation>
    </message>
    <message>
        <source>A corner is here. Let go and click the next one, or drag on to it.</source>
        <translation>Hier ist eine Ecke. Loslassen und die nächste anklicken, oder zu ihr weiterziehen.</translation>
    </message>
    <message>
        <source>%1 is locked: unlock it, or go to work on another segment.</source>
        <translation>%1 ist gesperrt: entsperren, oder an einem anderen Segment arbeiten.</translation>
    </message>
    <message>
        <source>Free-form: press and draw a line.</source>
        <translation>Freihand: drücken und eine Linie zeichnen.</translation>
    </message>
    <message>
        <source>Free-form: press and draw; it closes when you let go.</source>
        <translation>Freihand: drücken und zeichnen; Loslassen schließt den Umriss.</translation>
    </message>
    <message>
        <source>Polyline: click corner after corner.</source>
        <translation>Linienzug: Ecke um Ecke klicken.</translation>
    </message>
    <message>
        <source>Circle: drag from its centre to its rim.</source>
        <translation>Kreis: von der Mitte zum Rand ziehen.</translation>
    </message>
    <message>
        <source>Ellipse: drag from corner to corner of its box.</source>
        <translation>Ellipse: von Ecke zu Ecke ihres Rahmens ziehen.</translation>
    </message>
    <message>
        <source>Rectangle: drag from corner to corner.</source>
        <translation>Rechteck: von Ecke zu Ecke ziehen.</translation>
    </message>
    <message>
        <source>Picture: drag the box that it fills.</source>
        <translation>Bild: den Rahmen ziehen, den es füllt.</translation>
    </message>
    <message>
        <source>Esc drops it.</source>
        <translation>Esc verwirft alles.</translation>
    </message>
    <message>
        <source>Go on: nothing is enclosed yet.</source>
        <translation>Weiter: noch ist nichts umschlossen.</translation>
    </message>
    <message>
        <source>Length (steps)</source>
        <translation>Länge (Schritte)</translation>
    </message>
    <message>
        <source>Helix radius (steps)</source>
        <translation>Helixradius (Schritte)</translation>
    </message>
    <message>
        <source>Depth (steps)</source>
        <translation>Tiefe (Schritte)</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Turn the volume</source>
        <translation>Das Volumen drehen</translation>
    </message>
    <message>
        <source>Peel</source>
        <translation>Schälen</translation>
    </message>
    <message>
        <source>Peel layers off the surface</source>
        <translation>Lagen von der Oberfläche schälen</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Drill along the view</source>
        <translation>In Blickrichtung bohren</translation>
    </message>
    <message>
        <source>Laser</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>Burn down from the surface along its normal</source>
        <translation>Von der Oberfläche entlang ihrer Normale hineinbrennen</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Austragen</translation>
    </message>
    <message>
        <source>Sweep a shape along a way</source>
        <translation>Eine Form entlang eines Wegs austragen</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>Cut through everything inside a stroke, or outside it</source>
        <translation>Durch alles in einem Strich schneiden, oder durch alles außerhalb</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Keep what is connected to the place clicked, cut all else</source>
        <translation>Behalten, was mit der angeklickten Stelle verbunden ist, alles andere schneiden</translation>
    </message>
    <message>
        <source>Keep connected</source>
        <translation>Verbundenes behalten</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschneiden</translation>
    </message>
    <message>
        <source>Clip by a box and a plane</source>
        <translation>Mit Quader und Ebene beschneiden</translation>
    </message>
    <message>
        <source>Mark what should be segmented</source>
        <translation>Markieren, was segmentiert werden soll</translation>
    </message>
    <message>
        <source>Island</source>
        <translation>Insel</translation>
    </message>
    <message>
        <source>Drop the part of the segment that is clicked, or keep only it</source>
        <translation>Das angeklickte Teil des Segments verwerfen, oder nur es behalten</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Correct the segment with a brush, on the slices</source>
        <translation>Das Segment auf den Schichten mit dem Pinsel verbessern</translation>
    </message>
    <message>
        <source>Measure distances and angles, on the surface and on slices</source>
        <translation>Abstände und Winkel messen, auf der Oberfläche und auf Schichten</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Move part</source>
        <translation>Teil bewegen</translation>
    </message>
    <message>
        <source>Window of slices: level and width</source>
        <translation>Fenster der Schichten: Lage und Weite</translation>
    </message>
    <message>
        <source>Right button on a slice</source>
        <translation>Rechte Taste auf einer Schicht</translation>
    </message>
    <message>
        <source>Zoom a slice</source>
        <translation>Eine Schicht vergrößern</translation>
    </message>
    <message>
        <source>Ctrl+Right button, Ctrl+Wheel</source>
        <translation>Strg+rechte Taste, Strg+Mausrad</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>superior</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>%1: columns run to %2, rows to %3, slices to %4</source>
        <translation>%1: Spalten laufen nach %2, Zeilen nach %3, Schichten nach %4</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>, %1 not finite</source>
        <translation>, %1 nicht endlich</translation>
    </message>
    <message>
        <source>as they are stored</source>
        <translation>wie gespeichert</translation>
    </message>
    <message>
        <source>%1 × stored value %2 %3</source>
        <translation>%1 × gespeicherter Wert %2 %3</translation>
    </message>
    <message>
        <source>%1, angiography</source>
        <translation>%1, Angiographie</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels, %4, %5</source>
        <translation>%1 × %2 × %3 Voxel, %4, %5</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Ausdehnung</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>First voxel</source>
        <translation>Erstes Voxel</translation>
    </message>
    <message>
        <source>%1 mm (left, posterior, superior)</source>
        <translation>%1 mm (links, hinten, oben)</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>volume %1 of %2</source>
        <translation>Volumen %1 von %2</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>Interpolated slices</source>
        <translation>Interpolierte Schichten</translation>
    </message>
    <message>
        <source>Through all</source>
        <translation>Durch alles</translation>
    </message>
    <message>
        <source>Drills through all of the volume, instead of down to the depth</source>
        <translation>Bohrt durch das ganze Volumen statt bis zur Tiefe</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>The way is drawn along the pen</source>
        <translation>Der Weg folgt dem Stift</translation>
    </message>
    <message>
        <source>Polyline</source>
        <translation>Linienzug</translation>
    </message>
    <message>
        <source>Straight from corner to corner; Enter or a double click ends it</source>
        <translation>Gerade von Ecke zu Ecke; Eingabe oder ein Doppelklick beendet ihn</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Spline</translation>
    </message>
    <message>
        <source>A smooth curve through corners; Enter or a double click ends it</source>
        <translation>Eine glatte Kurve durch Ecken; Eingabe oder ein Doppelklick beendet sie</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>Raw energy, and the filter of the mask&apos;s edge</source>
        <translation>Rohe Energie und der Filter des Maskenrands</translation>
    </message>
    <message>
        <source>Raw energy</source>
        <translation>Rohe Energie</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>How the mask&apos;s edge is sampled</source>
        <translation>Wie der Rand der Maske abgetastet wird</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>What the samples are weighted by</source>
        <translation>Womit die Abtastwerte gewichtet werden</translation>
    </message>
    <message>
        <source>0.1 for each element of the mask instead of its volume: the cut&apos;s size follows the way&apos;s length in pixels</source>
        <translation>0,1 für jedes Element der Maske statt seines Volumens: Die Größe des Schnitts folgt der Länge des Wegs in Pixeln</translation>
    </message>
    <message>
        <source>%1 mm, %2</source>
        <translation>%1 mm, %2</translation>
    </message>
    <message>
        <source>The scan is mirrored against the file: left and right are exchanged.</source>
        <translation>Der Scan ist gegenüber der Datei gespiegelt: links und rechts sind vertauscht.</translation>
    </message>
    <message>
        <source>The scan is mirrored against the file: front and back are exchanged.</source>
        <translation>Der Scan ist gegenüber der Datei gespiegelt: vorn und hinten sind vertauscht.</translation>
    </message>
    <message>
        <source>The scan is mirrored against the file: top and bottom are exchanged.</source>
        <translation>Der Scan ist gegenüber der Datei gespiegelt: oben und unten sind vertauscht.</translation>
    </message>
    <message>
        <source>The scan is mirrored against the file.</source>
        <translation>Der Scan ist gegenüber der Datei gespiegelt.</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>In der Datei</translation>
    </message>
    <message>
        <source>Move, turn and scale pasted parts and segments that are pulled out</source>
        <translation>Eingefügte Teile und herausgezogene Segmente verschieben, drehen und vergrößern</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Along a line that is drawn, in mm</source>
        <translation>Entlang einer gezeichneten Linie, in mm</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Inside an outline that is drawn on a slice, with mean and spread of the values</source>
        <translation>In einem Umriss, der auf einem Schnitt gezeichnet wird, mit Mittelwert und Streuung der Werte</translation>
    </message>
    <message>
        <source>Volume of what is cut</source>
        <translation>Volumen des Weggeschnittenen</translation>
    </message>
    <message>
        <source>Measure how much is cut away, in ml</source>
        <translation>Messen, wie viel weggeschnitten ist, in ml</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Gefäß</translation>
    </message>
    <message>
        <source>Between two places along a segment: its centreline, its diameters, the narrowest of them</source>
        <translation>Zwischen zwei Stellen entlang eines Segments: Mittellinie, Durchmesser und die engste Stelle</translation>
    </message>
    <message>
        <source>Diameters along the vessel that was measured last</source>
        <translation>Durchmesser entlang des zuletzt gemessenen Gefäßes</translation>
    </message>
    <message>
        <source>%1 cannot be recovered</source>
        <translation>%1 kann nicht wiederhergestellt werden</translation>
    </message>
    <message>
        <source>%1: one edit was not saved</source>
        <translation>%1: eine Änderung wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>%1: %2 edits were not saved</source>
        <translation>%1: %2 Änderungen wurden nicht gespeichert</translation>
    </message>
    <message>
        <source>The program ended without being closed. Last edit: %1</source>
        <translation>Das Programm endete, ohne geschlossen zu werden. Letzte Änderung: %1</translation>
    </message>
    <message>
        <source>Its volume %1 is not there</source>
        <translation>Ihr Volumen %1 ist nicht da</translation>
    </message>
    <message>
        <source>Not all of it can be read: %1</source>
        <translation>Nicht alles davon ist lesbar: %1</translation>
    </message>
    <message>
        <source>Which level of a store of OME-Zarr; 0 is the finest.</source>
        <translation>Welche Stufe eines OME-Zarr-Speichers; 0 ist die feinste.</translation>
    </message>
    <message>
        <source>Which channel of a store, counted from 0.</source>
        <translation>Welcher Kanal eines Speichers, gezählt ab 0.</translation>
    </message>
    <message>
        <source>What volumes and edits may take on the device, for example 512MiB or 4GiB.</source>
        <translation>Was Volumen und Bearbeitungen auf dem Gerät belegen dürfen, zum Beispiel 512MiB oder 4GiB.</translation>
    </message>
    <message>
        <source>What they may take on the host, likewise.</source>
        <translation>Was sie im Arbeitsspeicher belegen dürfen, ebenso.</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>The pen lays its colour on the material (R)</source>
        <translation>Der Stift legt seine Farbe auf das Material (R)</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>The pen takes marks away (R)</source>
        <translation>Der Stift nimmt Markierungen weg (R)</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>A line along the shape that is drawn</source>
        <translation>Eine Linie entlang der gezeichneten Form</translation>
    </message>
    <message>
        <source>What the shape encloses</source>
        <translation>Was die Form umschließt</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Pfeil</translation>
    </message>
    <message>
        <source>A line with a head at its end</source>
        <translation>Eine Linie mit einer Spitze am Ende</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>Letters where one clicks, upright in the picture</source>
        <translation>Buchstaben, wo man klickt, aufrecht im Bild</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Colour of the pen</source>
        <translation>Farbe des Stifts</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Opacity of the pen, in percent</source>
        <translation>Deckkraft des Stifts in Prozent</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How much of the line is a soft rim, in percent</source>
        <translation>Wie viel der Linie weicher Rand ist, in Prozent</translation>
    </message>
    <message>
        <source>Soft rim</source>
        <translation>Weicher Rand</translation>
    </message>
    <message>
        <source>Width of lines on the surface, in mm</source>
        <translation>Breite der Linien auf der Oberfläche in mm</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Gestrichelt</translation>
    </message>
    <message>
        <source>Dashes three times as long as the line is wide</source>
        <translation>Striche, dreimal so lang, wie die Linie breit ist</translation>
    </message>
    <message>
        <source>A pen that is pressed less draws thinner lines</source>
        <translation>Ein schwächer aufgedrückter Stift zeichnet dünnere Linien</translation>
    </message>
    <message>
        <source>A pen that is pressed less draws paler lines</source>
        <translation>Ein schwächer aufgedrückter Stift zeichnet blassere Linien</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Lines are the same however hard the pen is pressed</source>
        <translation>Linien sind gleich, wie fest der Stift auch aufgedrückt wird</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Letters that are written</source>
        <translation>Buchstaben, die geschrieben werden</translation>
    </message>
    <message>
        <source>Height of letters, in mm</source>
        <translation>Höhe der Buchstaben in mm</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Remove all marks</source>
        <translation>Alle Markierungen entfernen</translation>
    </message>
    <message>
        <source>Take all marks away</source>
        <translation>Alle Markierungen wegnehmen</translation>
    </message>
    <message>
        <source>Draw with a marking pen on the surface; the marks stay on the material</source>
        <translation>Mit einem Markierstift auf die Oberfläche zeichnen; die Markierungen bleiben auf dem Material</translation>
    </message>
    <message>
        <source>Let go to mark it.</source>
        <translation>Loslassen markiert es.</translation>
    </message>
    <message>
        <source>Enter or a double click marks it.</source>
        <translation>Enter oder ein Doppelklick markiert es.</translation>
    </message>
    <message>
        <source>Click the first corner to close the line and mark it.</source>
        <translation>Ein Klick auf die erste Ecke schließt die Linie und markiert sie.</translation>
    </message>
    <message>
        <source>Let go to colour it.</source>
        <translation>Loslassen färbt es ein.</translation>
    </message>
    <message>
        <source>Enter, a double click or a click on the first corner colours it.</source>
        <translation>Enter, ein Doppelklick oder ein Klick auf die erste Ecke färbt es ein.</translation>
    </message>
    <message>
        <source>Click the first corner to colour it.</source>
        <translation>Ein Klick auf die erste Ecke färbt es ein.</translation>
    </message>
    <message>
        <source>Take away what is shown (Enter)</source>
        <translation>Das Gezeigte wegnehmen (Eingabe)</translation>
    </message>
    <message>
        <source>Fill what is shown (Enter)</source>
        <translation>Das Gezeigte füllen (Eingabe)</translation>
    </message>
    <message>
        <source>Let go to fill it.</source>
        <translation>Loslassen füllt es.</translation>
    </message>
    <message>
        <source>Enter, a double click or a click on the first corner fills it.</source>
        <translation>Eingabe, ein Doppelklick oder ein Klick auf die erste Ecke füllt es.</translation>
    </message>
    <message>
        <source>Click the first corner to fill it.</source>
        <translation>Klick auf die erste Ecke füllt es.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::BlockDialog</name>
    <message>
        <source>Sculpt from nothing</source>
        <translation>Aus dem Nichts formen</translation>
    </message>
    <message>
        <source>Size of the block</source>
        <translation>Größe des Blocks</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Voxels along %1</source>
        <translation>Voxel entlang %1</translation>
    </message>
    <message>
        <source>Spacing (mm)</source>
        <translation>Abstand (mm)</translation>
    </message>
    <message>
        <source>Spacing along %1, in mm</source>
        <translation>Abstand entlang %1, in mm</translation>
    </message>
    <message>
        <source>A solid block</source>
        <translation>Ein voller Block</translation>
    </message>
    <message>
        <source>What the tools cut is taken away from it</source>
        <translation>Was die Werkzeuge schneiden, wird von ihm weggenommen</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>What the tools cut is what is seen: it is built up</source>
        <translation>Was die Werkzeuge schneiden, ist zu sehen: so entsteht es</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>Anfangen mit</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 Bit</translation>
    </message>
    <message>
        <source>Least memory, for comparison</source>
        <translation>Der wenigste Speicher, zum Vergleich</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>As scans are sculpted</source>
        <translation>Wie Aufnahmen geformt werden</translation>
    </message>
    <message>
        <source>32 bits</source>
        <translation>32 Bit</translation>
    </message>
    <message>
        <source>Most memory, for comparison</source>
        <translation>Der meiste Speicher, zum Vergleich</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm, %4 million voxels</source>
        <translation>%1 × %2 × %3 mm, %4 Millionen Voxel</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm, %4 million voxels: at most %5 million are possible</source>
        <translation>%1 × %2 × %3 mm, %4 Millionen Voxel: höchstens %5 Millionen sind möglich</translation>
    </message>
</context>
<context>
    <name>vs::desktop::CameraMotion</name>
    <message>
        <source>Anterior</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Look at the face</source>
        <translation>Aufs Gesicht schauen</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Posterior</translation>
    </message>
    <message>
        <source>Look from behind</source>
        <translation>Von hinten schauen</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Look at the patient&apos;s left</source>
        <translation>Auf die linke Seite des Patienten schauen</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Look at the patient&apos;s right</source>
        <translation>Auf die rechte Seite des Patienten schauen</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>Superior</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>Von oben schauen</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Inferior</translation>
    </message>
    <message>
        <source>Look from below, as at axial slices</source>
        <translation>Von unten schauen, wie auf axiale Schichten</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show all that can be seen as large as there is room for</source>
        <translation>Alles, was zu sehen ist, so groß zeigen, wie Platz ist</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>Orthografisch</translation>
    </message>
    <message>
        <source>Without perspective: what is farther off is as large</source>
        <translation>Ohne Perspektive: was weiter weg ist, ist ebenso groß</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>The head stays up while the volume is turned, instead of rolling under the hand</source>
        <translation>Der Kopf bleibt oben, wenn gedreht wird, statt unter der Hand zu rollen</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Dragging turns the volume</source>
        <translation>Ziehen dreht das Volumen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Dragging moves the picture</source>
        <translation>Ziehen verschiebt das Bild</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Dragging up comes nearer, down steps back</source>
        <translation>Ziehen nach oben holt heran, nach unten geht zurück</translation>
    </message>
</context>
<context>
    <name>vs::desktop::CameraTool</name>
    <message>
        <source>Drag along the rim to roll the picture.</source>
        <translation>Am Rand entlang ziehen rollt das Bild.</translation>
    </message>
    <message>
        <source>Drag to turn, along the rim to roll. Middle button or Shift+drag moves, wheel or right button zooms, whatever the tool.</source>
        <translation>Ziehen dreht, am Rand entlang rollt es. Mittlere Taste oder Umschalt+Ziehen verschiebt, Rad oder rechte Taste zoomt, bei jedem Werkzeug.</translation>
    </message>
    <message>
        <source>Drag to move the picture, along the rim to roll. Wheel or right button zooms.</source>
        <translation>Ziehen verschiebt das Bild, am Rand rollt es. Rad oder rechte Taste zoomt.</translation>
    </message>
    <message>
        <source>Drag up to come nearer, down to step back, along the rim to roll.</source>
        <translation>Nach oben ziehen holt heran, nach unten geht zurück, am Rand rollt es.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::ChartWidget</name>
    <message>
        <source>pale: cut away</source>
        <translation>blass: weggeschnitten</translation>
    </message>
    <message>
        <source>No volume</source>
        <translation>Kein Volumen</translation>
    </message>
</context>
<context>
    <name>vs::desktop::ClipTool</name>
    <message>
        <source>Move the faces of the box, or the plane, in the panel on the left: what lies outside is put back. Drag to turn.</source>
        <translation>Die Flächen des Quaders oder die Ebene im Feld links bewegen: was außerhalb liegt, wird wieder aufgefüllt. Ziehen dreht.</translation>
    </message>
    <message>
        <source>Move the faces of the box, or the plane, in the panel on the left: what lies outside is cut. Drag to turn.</source>
        <translation>Die Flächen des Quaders oder die Ebene im Feld links bewegen: was außerhalb liegt, wird geschnitten. Ziehen dreht.</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Posterior</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>Superior</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Inferior</translation>
    </message>
    <message>
        <source>Nothing is clipped</source>
        <translation>Nichts ist beschnitten</translation>
    </message>
    <message>
        <source>Move the faces of the box, or the plane, in the panel on the left: what lies inside is put back. Drag to turn.</source>
        <translation>Die Flächen des Quaders oder die Ebene im Feld links bewegen: was innerhalb liegt, wird wieder aufgefüllt. Ziehen dreht.</translation>
    </message>
    <message>
        <source>Move the faces of the box, or the plane, in the panel on the left: what lies inside is cut. Drag to turn.</source>
        <translation>Die Flächen des Quaders oder die Ebene im Feld links bewegen: was innerhalb liegt, wird geschnitten. Ziehen dreht.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::ColourButton</name>
    <message>
        <source>The colour; click to choose another one</source>
        <translation>Die Farbe; Klicken wählt eine andere</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
</context>
<context>
    <name>vs::desktop::CurvePage</name>
    <message>
        <source>Opacity and colour over gradient magnitude</source>
        <translation>Deckkraft und Farbe über dem Gradientenbetrag</translation>
    </message>
    <message>
        <source>Opacity and colour over intensity</source>
        <translation>Deckkraft und Farbe über der Intensität</translation>
    </message>
    <message>
        <source>Click: a new point. Drag a point, or a whole hill by its middle. Double click: its colour. Right button: remove.
Tab: the next point; arrow keys move it; Delete; Return: its colour; Ctrl+Z. Wheel: closer.</source>
        <translation>Klick: ein neuer Punkt. Punkt ziehen, oder einen ganzen Hügel an seiner Mitte. Doppelklick: seine Farbe. Rechte Taste: entfernen.
Tab: der nächste Punkt; Pfeiltasten bewegen ihn; Entf; Eingabe: seine Farbe; Strg+Z. Rad: näher.</translation>
    </message>
    <message>
        <source>Gradient magnitude of the chosen point</source>
        <translation>Gradientenbetrag des gewählten Punkts</translation>
    </message>
    <message>
        <source>Intensity of the chosen point</source>
        <translation>Intensität des gewählten Punkts</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>Counting…</source>
        <translation>Wird gezählt…</translation>
    </message>
    <message>
        <source>%1 lies beyond the next point: this one was put to %2</source>
        <translation>%1 liegt hinter dem nächsten Punkt: dieser kam auf %2</translation>
    </message>
</context>
<context>
    <name>vs::desktop::CutTool</name>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Cuts the scan, or puts back what was cut</source>
        <translation>Schneidet den Scan oder füllt auf, was geschnitten war</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>Takes away from the segment at work, or adds to it; the scan stays as it is</source>
        <translation>Nimmt vom aktiven Segment weg oder fügt hinzu; der Scan bleibt, wie er ist</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Takes away from the segment at work (R)</source>
        <translation>Nimmt vom aktiven Segment weg (R)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Adds to it what is in the displayed range (R)</source>
        <translation>Fügt ihm hinzu, was im angezeigten Bereich liegt (R)</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Takes away (R)</source>
        <translation>Nimmt weg (R)</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Auffüllen</translation>
    </message>
    <message>
        <source>Puts back what was cut, never more than there was (R)</source>
        <translation>Füllt auf, was geschnitten war, nie mehr als da war (R)</translation>
    </message>
    <message>
        <source>What it takes is added to %1, the scan stays. R removes.</source>
        <translation>Was es erfasst, kommt zu %1, der Scan bleibt. R entfernt.</translation>
    </message>
    <message>
        <source>What it takes is removed from %1, the scan stays. R adds.</source>
        <translation>Was es erfasst, fällt aus %1 heraus, der Scan bleibt. R fügt hinzu.</translation>
    </message>
    <message>
        <source>Radius of the cut&apos;s soft edge in steps (a step is the smallest voxel spacing): the larger, the rounder are the cut&apos;s edges</source>
        <translation>Radius des weichen Schnittrands in Schritten (ein Schritt ist der kleinste Voxelabstand): je größer, desto runder die Ränder des Schnitts</translation>
    </message>
    <message>
        <source>Radius (steps)</source>
        <translation>Radius (Schritte)</translation>
    </message>
    <message>
        <source>%1 · %2 mm</source>
        <translation>%1 · %2 mm</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
    <message>
        <source>Only %1 is taken.</source>
        <translation>Nur %1 wird genommen.</translation>
    </message>
    <message>
        <source>Spared: %1.</source>
        <translation>Verschont: %1.</translation>
    </message>
    <message>
        <source>Takes the segment at work like all else</source>
        <translation>Nimmt das aktive Segment wie alles andere</translation>
    </message>
    <message>
        <source>Spares the segment at work: cuts end at its surface</source>
        <translation>Verschont das aktive Segment: Schnitte enden an seiner Oberfläche</translation>
    </message>
    <message>
        <source>Takes nothing but the segment at work: cuts end at its surface</source>
        <translation>Nimmt nichts als das aktive Segment: Schnitte enden an seiner Oberfläche</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Nehmen</translation>
    </message>
    <message>
        <source>Spare</source>
        <translation>Schonen</translation>
    </message>
    <message>
        <source>Only</source>
        <translation>Nur dies</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Adds material, or takes it away; the scan stays as it is</source>
        <translation>Fügt Material hinzu oder nimmt es weg; der Scan bleibt, wie er ist</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Adds material (R)</source>
        <translation>Fügt Material hinzu (R)</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>Takes material away; the scan stays (R)</source>
        <translation>Nimmt Material weg; der Scan bleibt (R)</translation>
    </message>
    <message>
        <source>Material to fill with</source>
        <translation>Material, mit dem gefüllt wird</translation>
    </message>
    <message>
        <source>Colour of the material</source>
        <translation>Farbe des Materials</translation>
    </message>
    <message>
        <source>Name of the material</source>
        <translation>Name des Materials</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Intensity of the material, as the scan&apos;s values are</source>
        <translation>Intensität des Materials, wie die Werte des Scans</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>The next click on the picture takes the scan&apos;s value there</source>
        <translation>Der nächste Klick auf das Bild nimmt den Wert des Scans dort</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Whether this material is seen</source>
        <translation>Ob dieses Material zu sehen ist</translation>
    </message>
    <message>
        <source>Takes all of this material away</source>
        <translation>Nimmt alles von diesem Material weg</translation>
    </message>
    <message>
        <source>New material</source>
        <translation>Neues Material</translation>
    </message>
    <message>
        <source>Nothing is seen there whose value could be taken</source>
        <translation>Dort ist nichts zu sehen, dessen Wert man nehmen könnte</translation>
    </message>
    <message>
        <source>Click where the scan has the value that the material should have.</source>
        <translation>Dorthin klicken, wo der Scan den Wert hat, den das Material haben soll.</translation>
    </message>
    <message>
        <source>It takes material away, the scan stays. R fills.</source>
        <translation>Es nimmt Material weg, der Scan bleibt. R füllt.</translation>
    </message>
    <message>
        <source>It adds material, outward from the surface. R takes it away.</source>
        <translation>Es fügt Material hinzu, von der Oberfläche nach außen. R nimmt es weg.</translation>
    </message>
    <message>
        <source>To segment</source>
        <translation>Zum Segment</translation>
    </message>
    <message>
        <source>Adds what is filled with this material to the segment at work</source>
        <translation>Fügt dem Segment in Arbeit hinzu, was mit diesem Material gefüllt ist</translation>
    </message>
</context>
<context>
    <name>vs::desktop::DocumentExport</name>
    <message>
        <source>The export was given up</source>
        <translation>Der Export wurde aufgegeben</translation>
    </message>
    <message>
        <source>The document changed: the export was given up</source>
        <translation>Das Dokument wurde geändert: der Export wurde aufgegeben</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>Exportiert: %1</translation>
    </message>
    <message>
        <source>Exported %1 files up to %2</source>
        <translation>%1 Dateien exportiert bis %2</translation>
    </message>
    <message>
        <source>There is not enough memory for this export; close what is open, or keep fewer triangles</source>
        <translation>Der Speicher reicht für diesen Export nicht; anderes schließen oder weniger Dreiecke behalten</translation>
    </message>
</context>
<context>
    <name>vs::desktop::DocumentFiles</name>
    <message>
        <source>Given up: nothing was opened</source>
        <translation>Abgebrochen: Nichts wurde geöffnet</translation>
    </message>
    <message>
        <source>%1 holds several series</source>
        <translation>%1 enthält mehrere Serien</translation>
    </message>
    <message>
        <source>Still reading; open it again when that is done</source>
        <translation>Liest noch; danach noch einmal öffnen</translation>
    </message>
    <message>
        <source>Recovering</source>
        <translation>Stellt wieder her</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Liest %1</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 geöffnet</translation>
    </message>
    <message>
        <source>Replaying %1 of %2: %3</source>
        <translation>Spielt %1 von %2 nach: %3</translation>
    </message>
    <message>
        <source>Replayed up to operation %1 (%2): %3</source>
        <translation>Nachgespielt bis Schritt %1 (%2): %3</translation>
    </message>
    <message>
        <source>Replayed %1 operations</source>
        <translation>%1 Schritte nachgespielt</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>There is no segmentation to export yet: draw seeds first</source>
        <translation>Noch keine Segmentierung zum Exportieren: zuerst säen</translation>
    </message>
    <message>
        <source>Exported labels to %1</source>
        <translation>Labels nach %1 exportiert</translation>
    </message>
    <message>
        <source>Making a block</source>
        <translation>Ein Block wird gemacht</translation>
    </message>
    <message>
        <source>Making the scan</source>
        <translation>Der Scan wird gemacht</translation>
    </message>
    <message>
        <source>%1 is not where %2 says</source>
        <translation>%1 ist nicht dort, wo %2 sagt</translation>
    </message>
    <message>
        <source>Opened %1 as it was saved</source>
        <translation>%1 geöffnet, wie es gespeichert wurde</translation>
    </message>
    <message>
        <source>%1 is not where it was</source>
        <translation>%1 ist nicht mehr, wo es war</translation>
    </message>
</context>
<context>
    <name>vs::desktop::DocumentHost</name>
    <message>
        <source>Given up: nothing was changed</source>
        <translation>Abgebrochen: Nichts wurde geändert</translation>
    </message>
    <message>
        <source>There is no memory for that: nothing was changed; end other programs, or use a smaller volume</source>
        <translation>Dafür ist kein Speicher da: Es wurde nichts geändert; beenden Sie andere Programme, oder nehmen Sie ein kleineres Volumen</translation>
    </message>
</context>
<context>
    <name>vs::desktop::DrillTool</name>
    <message>
        <source>The mask follows the pen. Press and move to fill in what was cut. Esc clears it for a new shape.</source>
        <translation>Die Maske folgt dem Stift. Drücken und bewegen füllt auf, was geschnitten war. Esc löscht sie für eine neue Form.</translation>
    </message>
    <message>
        <source>Filling in: press harder to fill more. Let go to keep, Esc to undo.</source>
        <translation>Füllt auf: fester drücken füllt mehr. Loslassen behält, Esc macht rückgängig.</translation>
    </message>
    <message>
        <source>The mask follows the pen. Press and move to drill. Esc clears it for a new shape.</source>
        <translation>Die Maske folgt dem Stift. Drücken und bewegen bohrt. Esc löscht sie für eine neue Form.</translation>
    </message>
    <message>
        <source>Drilling: press harder to go deeper. Let go to keep, Esc to undo.</source>
        <translation>Bohrt: fester drücken geht tiefer. Loslassen behält, Esc macht rückgängig.</translation>
    </message>
    <message>
        <source>Draw the shape of the drill anywhere.</source>
        <translation>Die Form des Bohrers irgendwo zeichnen.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::Editor</name>
    <message>
        <source>Undone: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>Wiederholt: %1</translation>
    </message>
    <message>
        <source>Nothing was changed</source>
        <translation>Nichts wurde geändert</translation>
    </message>
    <message>
        <source>Nothing to paste: nothing visible was cut since the last paste</source>
        <translation>Nichts einzufügen: seit dem letzten Einfügen wurde nichts Sichtbares geschnitten</translation>
    </message>
    <message>
        <source>Nothing to pull out: the segment is empty</source>
        <translation>Nichts herauszuziehen: das Segment ist leer</translation>
    </message>
    <message>
        <source>Nothing to paste: tools have cut nothing visible since the last paste. What Keep and Clip took away: Edit &gt; Paste All</source>
        <translation>Nichts einzufügen: Seit dem letzten Einfügen haben Werkzeuge nichts Sichtbares weggeschnitten. Was Behalten und Beschneiden weggenommen haben: Bearbeiten &gt; Alles einfügen</translation>
    </message>
</context>
<context>
    <name>vs::desktop::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Surfaces of segments, label maps and DICOM segmentations</source>
        <translation>Oberflächen von Segmenten, Labelkarten und DICOM-Segmentierungen</translation>
    </message>
    <message>
        <source>Sculpted volume</source>
        <translation>Bearbeitetes Volumen</translation>
    </message>
    <message>
        <source>What is left of the scan: its surface, or its values</source>
        <translation>Was vom Scan übrig ist: seine Oberfläche oder seine Werte</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>The numbers of segments, for a spreadsheet</source>
        <translation>Die Zahlen der Segmente, für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Takes steps between slices away and keeps the volume</source>
        <translation>Nimmt Stufen zwischen Schichten weg und erhält das Volumen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Triangles to keep</source>
        <translation>Dreiecke, die bleiben</translation>
    </message>
    <message>
        <source>Fewer triangles make smaller files; flat places lose them first</source>
        <translation>Weniger Dreiecke geben kleinere Dateien; flache Stellen verlieren sie zuerst</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>A file for each segment</source>
        <translation>Eine Datei je Segment</translation>
    </message>
    <message>
        <source>Named after the file and the segment</source>
        <translation>Nach der Datei und dem Segment benannt</translation>
    </message>
    <message>
        <source>Values from</source>
        <translation>Werte von</translation>
    </message>
    <message>
        <source>Values to</source>
        <translation>Werte bis</translation>
    </message>
    <message>
        <source>The surface of values in this range, at first the displayed one</source>
        <translation>Die Oberfläche der Werte in diesem Bereich, zuerst dem angezeigten</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Value of what is cut</source>
        <translation>Wert des Weggeschnittenen</translation>
    </message>
    <message>
        <source>What is written where the scan was cut away</source>
        <translation>Was dort steht, wo der Scan weggeschnitten wurde</translation>
    </message>
    <message>
        <source>Cut away becomes</source>
        <translation>Weggeschnittenes wird</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>No segment has voxels yet: seed and grow one first.</source>
        <translation>Noch hat kein Segment Voxel: zuerst eines säen und wachsen lassen.</translation>
    </message>
    <message>
        <source>about %1 triangles, %2</source>
        <translation>etwa %1 Dreiecke, %2</translation>
    </message>
    <message>
        <source>%1 (*%2)</source>
        <translation>%1 (*%2)</translation>
    </message>
</context>
<context>
    <name>vs::desktop::FilmDialog</name>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play the preview</source>
        <translation>Die Vorschau abspielen</translation>
    </message>
    <message>
        <source>Moment of the film</source>
        <translation>Zeitpunkt im Film</translation>
    </message>
    <message>
        <source>What the film shows</source>
        <translation>Was der Film zeigt</translation>
    </message>
    <message>
        <source>Around the patient&apos;s axis</source>
        <translation>Um die Achse des Patienten</translation>
    </message>
    <message>
        <source>To and fro</source>
        <translation>Hin und her</translation>
    </message>
    <message>
        <source>Over the head</source>
        <translation>Über den Kopf</translation>
    </message>
    <message>
        <source>Around and up</source>
        <translation>Herum und hinauf</translation>
    </message>
    <message>
        <source>Coming nearer</source>
        <translation>Näher heran</translation>
    </message>
    <message>
        <source>The segment growing</source>
        <translation>Das Segment, wie es wächst</translation>
    </message>
    <message>
        <source>The segment going back to its seeds</source>
        <translation>Das Segment, zurück zu seiner Saat</translation>
    </message>
    <message>
        <source>All that was done, with its strokes</source>
        <translation>Alles, was getan wurde, mit den Strichen</translation>
    </message>
    <message>
        <source>From view to view</source>
        <translation>Von Ansicht zu Ansicht</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>Zeigt</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>How far it turns</source>
        <translation>Wie weit er sich dreht</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turns by</source>
        <translation>Dreht um</translation>
    </message>
    <message>
        <source>How much nearer it comes</source>
        <translation>Wie viel näher er kommt</translation>
    </message>
    <message>
        <source>Nearer by</source>
        <translation>Näher um</translation>
    </message>
    <message>
        <source>Turn once meanwhile</source>
        <translation>Dabei einmal drehen</translation>
    </message>
    <message>
        <source>Goes around the patient&apos;s axis too</source>
        <translation>Dreht sich dabei um die Achse des Patienten</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Frames a second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source>%1 a second</source>
        <translation>%1 je Sekunde</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>Wie im Fenster</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Scale bar and orientation marker</source>
        <translation>Maßstab und Richtungswürfel</translation>
    </message>
    <message>
        <source>Draws both into the picture</source>
        <translation>Zeichnet beide ins Bild</translation>
    </message>
    <message>
        <source>Views of the film</source>
        <translation>Ansichten des Films</translation>
    </message>
    <message>
        <source>Add this view</source>
        <translation>Diese Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>Add what the window shows now: view, displayed range, parts, generation</source>
        <translation>Hinzufügen, was das Fenster jetzt zeigt: Ansicht, Wertebereich, Teile, Generation</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the view that is chosen</source>
        <translation>Die gewählte Ansicht entfernen</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>View %1: %2° around, %3° up, zoom %4</source>
        <translation>Ansicht %1: %2° herum, %3° hinauf, Zoom %4</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Turn to a view, and add it</source>
        <translation>Eine Ansicht einstellen und hinzufügen</translation>
    </message>
    <message>
        <source>Save the film</source>
        <translation>Film speichern</translation>
    </message>
    <message>
        <source>Films (*.webm *.mp4);;Folders of numbered pictures (*)</source>
        <translation>Filme (*.webm *.mp4);;Ordner mit nummerierten Bildern (*)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
</context>
<context>
    <name>vs::desktop::FunctionBar</name>
    <message>
        <source>Choose colours</source>
        <translation>Farben wählen</translation>
    </message>
    <message>
        <source>The transfer function in use; click to choose another one</source>
        <translation>Die benutzte Transferfunktion; Klicken wählt eine andere</translation>
    </message>
    <message>
        <source>Reset colours</source>
        <translation>Farben zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the mode&apos;s own colours</source>
        <translation>Zurück zu den eigenen Farben des Modus</translation>
    </message>
    <message>
        <source>Open colours</source>
        <translation>Farben öffnen</translation>
    </message>
    <message>
        <source>Open a transfer function from a file</source>
        <translation>Eine Transferfunktion aus einer Datei öffnen</translation>
    </message>
    <message>
        <source>Save colours</source>
        <translation>Farben speichern</translation>
    </message>
    <message>
        <source>Save the transfer function as a file</source>
        <translation>Die Transferfunktion als Datei speichern</translation>
    </message>
    <message>
        <source>The mode&apos;s own colours</source>
        <translation>Farben des Modus</translation>
    </message>
    <message>
        <source>Colours of your own</source>
        <translation>Eigene Farben</translation>
    </message>
    <message>
        <source>Open a transfer function</source>
        <translation>Transferfunktion öffnen</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>Transferfunktionen (*.json)</translation>
    </message>
    <message>
        <source>Opened colours %1</source>
        <translation>Farben %1 geöffnet</translation>
    </message>
    <message>
        <source>Save the transfer function</source>
        <translation>Transferfunktion speichern</translation>
    </message>
    <message>
        <source>Saved colours %1</source>
        <translation>Farben %1 gespeichert</translation>
    </message>
</context>
<context>
    <name>vs::desktop::FunctionEditor</name>
    <message>
        <source>A colour table is for functions over intensity or gradient; shapes have a colour each</source>
        <translation>Eine Farbtabelle gehört zu Funktionen über Intensität oder Gradient; Formen haben je eine Farbe</translation>
    </message>
</context>
<context>
    <name>vs::desktop::FunctionGallery</name>
    <message>
        <source>Transfer functions and colour tables</source>
        <translation>Transferfunktionen und Farbtabellen</translation>
    </message>
    <message>
        <source>Transfer functions</source>
        <translation>Transferfunktionen</translation>
    </message>
    <message>
        <source>Colour table of the points</source>
        <translation>Farbtabelle der Punkte</translation>
    </message>
    <message>
        <source>The mode&apos;s own</source>
        <translation>Die des Modus</translation>
    </message>
    <message>
        <source>Ivory surfaces and white rays; the volume as the displayed range has it</source>
        <translation>Elfenbeinfarbene Oberflächen und weiße Strahlen; das Volumen, wie der angezeigte Bereich es hat</translation>
    </message>
    <message>
        <source>their own</source>
        <translation>eigene</translation>
    </message>
    <message>
        <source>Each point has a colour of its own</source>
        <translation>Jeder Punkt hat eine eigene Farbe</translation>
    </message>
</context>
<context>
    <name>vs::desktop::FunctionPage</name>
    <message>
        <source>Opacity of the chosen part, in percent</source>
        <translation>Deckkraft des gewählten Teils, in Prozent</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Colour of the chosen part</source>
        <translation>Farbe des gewählten Teils</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add one in the middle; then drag it where it belongs</source>
        <translation>Eines in der Mitte hinzufügen und dann an seinen Platz ziehen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen one (Delete, or the right button)</source>
        <translation>Das gewählte entfernen (Entf oder rechte Taste)</translation>
    </message>
    <message>
        <source>Undo the last change of colours</source>
        <translation>Die letzte Änderung der Farben rückgängig machen</translation>
    </message>
    <message>
        <source>Undo the last change of colours (Ctrl+Z on the chart)</source>
        <translation>Die letzte Änderung der Farben rückgängig machen (Strg+Z auf dem Diagramm)</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkr.</translation>
    </message>
    <message>
        <source>Where this is seen</source>
        <translation>Wo dies zu sehen ist</translation>
    </message>
    <message>
        <source>no counts</source>
        <translation>keine Anzahlen</translation>
    </message>
    <message>
        <source>%1 of %2 chosen</source>
        <translation>%1 von %2 gewählt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Not in use: edit it, or &lt;a href=&quot;use&quot;&gt;use it as it is&lt;/a&gt;.</source>
        <translation>Nicht in Gebrauch: bearbeiten oder &lt;a href=&quot;use&quot;&gt;so verwenden&lt;/a&gt;.</translation>
    </message>
    <message>
        <source>Opacities show in &lt;a href=&quot;volume&quot;&gt;volume mode&lt;/a&gt;.</source>
        <translation>Deckkraft zeigt sich im &lt;a href=&quot;volume&quot;&gt;Volumenmodus&lt;/a&gt;.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::GeometryCard</name>
    <message>
        <source>Correct</source>
        <translation>Berichtigen</translation>
    </message>
    <message>
        <source>Flip and turn these slices until they are what the letters at their edges say. Voxels keep their values and their cuts; the file is never changed.</source>
        <translation>Spiegeln und drehen Sie diese Schichten, bis sie zeigen, was die Buchstaben an ihren Rändern sagen. Voxel behalten ihre Werte und Schnitte; die Datei wird nie geändert.</translation>
    </message>
    <message>
        <source>What the correction means</source>
        <translation>Was die Berichtigung bedeutet</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Flip left and right: %1</source>
        <translation>Links und rechts tauschen: %1</translation>
    </message>
    <message>
        <source>Exchanges left and right of this slice; this alone mirrors the scan</source>
        <translation>Vertauscht links und rechts dieser Schicht; das allein spiegelt den Scan</translation>
    </message>
    <message>
        <source>Flip top and bottom: %1</source>
        <translation>Oben und unten tauschen: %1</translation>
    </message>
    <message>
        <source>Exchanges top and bottom of this slice; this alone mirrors the scan</source>
        <translation>Vertauscht oben und unten dieser Schicht; das allein spiegelt den Scan</translation>
    </message>
    <message>
        <source>Turn by a quarter: %1</source>
        <translation>Um ein Viertel drehen: %1</translation>
    </message>
    <message>
        <source>Turns this slice clockwise by a quarter</source>
        <translation>Dreht diese Schicht um ein Viertel im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Exchange axes: %1</source>
        <translation>Achsen tauschen: %1</translation>
    </message>
    <message>
        <source>Exchanges two axes: what runs across this slice runs down; this alone mirrors the scan</source>
        <translation>Vertauscht zwei Achsen: was quer durch diese Schicht läuft, läuft dann abwärts; das allein spiegelt den Scan</translation>
    </message>
    <message>
        <source>Spacing (mm)</source>
        <translation>Abstand (mm)</translation>
    </message>
    <message>
        <source>Spacing of columns in mm</source>
        <translation>Abstand der Spalten in mm</translation>
    </message>
    <message>
        <source>Spacing of rows in mm</source>
        <translation>Abstand der Zeilen in mm</translation>
    </message>
    <message>
        <source>Spacing of slices in mm</source>
        <translation>Abstand der Schichten in mm</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Wie in der Datei</translation>
    </message>
    <message>
        <source>Spacing and orientation that the file says</source>
        <translation>Abstand und Ausrichtung laut Datei</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Corrects the scan; this can be undone</source>
        <translation>Berichtigt den Scan; das lässt sich zurücknehmen</translation>
    </message>
    <message>
        <source>As in the file: %1.</source>
        <translation>Wie in der Datei: %1.</translation>
    </message>
    <message>
        <source>%1; in the file %2.</source>
        <translation>%1; in der Datei %2.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::GrowthController</name>
    <message>
        <source>Playing backward</source>
        <translation>Spielt rückwärts</translation>
    </message>
    <message>
        <source>Absorbing</source>
        <translation>Absorbiert</translation>
    </message>
    <message>
        <source>Growing to the end</source>
        <translation>Wächst bis zum Ende</translation>
    </message>
    <message>
        <source>Growing</source>
        <translation>Wächst</translation>
    </message>
    <message>
        <source>Stopped at %1 % of what is displayed: play goes on</source>
        <translation>Bei %1 % des Sichtbaren angehalten: Abspielen setzt fort</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Beendet</translation>
    </message>
</context>
<context>
    <name>vs::desktop::GrowthPanel</name>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Add a segment</source>
        <translation>Segment hinzufügen</translation>
    </message>
    <message>
        <source>A fresh segment: new strokes go there (Ctrl+Shift+N)</source>
        <translation>Ein frisches Segment: neue Striche gehen dorthin (Strg+Umschalt+N)</translation>
    </message>
    <message>
        <source>Remove the segment</source>
        <translation>Das Segment entfernen</translation>
    </message>
    <message>
        <source>Erase the segment at work and forget its name (Delete in the list)</source>
        <translation>Das aktive Segment löschen und seinen Namen vergessen (Entf in der Liste)</translation>
    </message>
    <message>
        <source>Opacity of the segment at work, in percent</source>
        <translation>Deckkraft des aktiven Segments, in Prozent</translation>
    </message>
    <message>
        <source>How much the segment at work hides</source>
        <translation>Wie viel das aktive Segment verdeckt</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>One generation back</source>
        <translation>Eine Generation zurück</translation>
    </message>
    <message>
        <source>One generation back; hold for more ( , )</source>
        <translation>Eine Generation zurück; halten für mehr ( , )</translation>
    </message>
    <message>
        <source>Play backward</source>
        <translation>Rückwärts spielen</translation>
    </message>
    <message>
        <source>Play backward, down to the seeds (Shift+B)</source>
        <translation>Rückwärts spielen, bis zur Saat (Umschalt+B)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pause: what has grown stays, and play goes on from it (Shift+G)</source>
        <translation>Pause: das Gewachsene bleibt, und es geht von dort weiter (Umschalt+G)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Let the region grow (Shift+G)</source>
        <translation>Den Bereich wachsen lassen (Umschalt+G)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>One generation further; hold for more ( . )</source>
        <translation>Eine Generation weiter; halten für mehr ( . )</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Bis zum Ende</translation>
    </message>
    <message>
        <source>Grow until nothing grows any more (Ctrl+G)</source>
        <translation>Wachsen, bis nichts mehr wächst (Strg+G)</translation>
    </message>
    <message>
        <source>Generation shown</source>
        <translation>Gezeigte Generation</translation>
    </message>
    <message>
        <source>Generation</source>
        <translation>Generation</translation>
    </message>
    <message>
        <source>Auto start</source>
        <translation>Autostart</translation>
    </message>
    <message>
        <source>Start growing as soon as seeds are drawn</source>
        <translation>Wächst, sobald gesät ist</translation>
    </message>
    <message>
        <source>Generations per second</source>
        <translation>Generationen je Sekunde</translation>
    </message>
    <message>
        <source>full speed</source>
        <translation>volles Tempo</translation>
    </message>
    <message>
        <source> per s</source>
        <translation> je s</translation>
    </message>
    <message>
        <source>Generations per second; 0 grows as fast as it can</source>
        <translation>Generationen je Sekunde; 0 wächst, so schnell es geht</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>no seeds yet</source>
        <translation>noch keine Saat</translation>
    </message>
    <message>
        <source>Search segments</source>
        <translation>Segmente suchen</translation>
    </message>
    <message>
        <source>Drag through the generations; growing goes on from the one shown. Marks are where it may have leaked: click one to go back to just before it</source>
        <translation>Durch die Generationen ziehen; von der gezeigten an wächst es weiter. Marken zeigen, wo es ausgelaufen sein kann: ein Klick führt zurück bis kurz davor</translation>
    </message>
    <message>
        <source>Why growth has stopped</source>
        <translation>Warum das Wachsen angehalten hat</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Let the region grow on, without a limit</source>
        <translation>Die Region ohne Grenze weiterwachsen lassen</translation>
    </message>
    <message>
        <source>Size at which a first stroke stops, in percent</source>
        <translation>Größe, bei der ein erster Strich anhält, in Prozent</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>A segment&apos;s first stroke stops growing when it has so much of what is displayed; 0: never</source>
        <translation>Der erste Strich eines Segments hält an, wenn es so viel vom Sichtbaren hat; 0: nie</translation>
    </message>
    <message>
        <source>A first stroke stops at</source>
        <translation>Ein erster Strich hält an bei</translation>
    </message>
    <message>
        <source>Stopped at %1 % of what is displayed, %2 voxels</source>
        <translation>Bei %1 % des Sichtbaren angehalten, %2 Voxel</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Stop: what has grown stays, and nothing goes on by itself</source>
        <translation>Beenden: Was gewachsen ist, bleibt, und nichts geht von selbst weiter</translation>
    </message>
</context>
<context>
    <name>vs::desktop::GrowthRulesPanel</name>
    <message>
        <source>Growth rules</source>
        <translation>Wachstumsregeln</translation>
    </message>
    <message>
        <source>Intensities that may grow</source>
        <translation>Intensitäten, die wachsen dürfen</translation>
    </message>
    <message>
        <source>Histogram with the range that may grow</source>
        <translation>Histogramm mit dem Bereich, der wachsen darf</translation>
    </message>
    <message>
        <source>Drag the handles, or the band between them: what may grow. The bars in the segment&apos;s colour are its own voxels</source>
        <translation>Griffe oder das Band dazwischen ziehen: was wachsen darf. Die Balken in der Farbe des Segments sind seine eigenen Voxel</translation>
    </message>
    <message>
        <source>Lower end of the run&apos;s intensity range</source>
        <translation>Unteres Ende des Intensitätsbereichs</translation>
    </message>
    <message>
        <source>Upper end of the run&apos;s intensity range</source>
        <translation>Oberes Ende des Intensitätsbereichs</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Strokes bring the displayed range</source>
        <translation>Striche bringen den Bereich mit</translation>
    </message>
    <message>
        <source>A stroke sets this range to the one that is displayed; off: strokes go by the range set here</source>
        <translation>Ein Strich setzt diesen Bereich auf den angezeigten; aus: Striche gehen nach dem hier gesetzten</translation>
    </message>
    <message>
        <source>%1: least</source>
        <translation>%1: mindestens</translation>
    </message>
    <message>
        <source>%1: most</source>
        <translation>%1: höchstens</translation>
    </message>
    <message>
        <source>6</source>
        <translation>6</translation>
    </message>
    <message>
        <source>Voxels that share a face</source>
        <translation>Voxel mit gemeinsamer Fläche</translation>
    </message>
    <message>
        <source>26</source>
        <translation>26</translation>
    </message>
    <message>
        <source>Voxels that touch at an edge or a corner too</source>
        <translation>Auch Voxel, die sich an Kante oder Ecke berühren</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>Live: tightening takes away</source>
        <translation>Live: Verengen nimmt weg</translation>
    </message>
    <message>
        <source>What could not be reached under tighter rules goes at once; off: rules hold for what is still to grow</source>
        <translation>Was unter engeren Regeln nicht erreichbar wäre, fällt sofort weg; aus: Regeln gelten für das, was noch wächst</translation>
    </message>
    <message>
        <source>What was cut away fences it, as the view shows it (Cut, Probe, Whole).</source>
        <translation>Weggeschnittenes ist die Grenze, wie die Ansicht es zeigt (Schnitt, Probe, Ganz).</translation>
    </message>
</context>
<context>
    <name>vs::desktop::Hand</name>
    <message>
        <source>Drag a box for the shape of %1</source>
        <translation>Einen Kasten aufziehen für die Form von %1</translation>
    </message>
</context>
<context>
    <name>vs::desktop::HistogramPanel</name>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>The displayed range of intensities</source>
        <translation>Der angezeigte Bereich der Intensitäten</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>Colour and opacity over intensity</source>
        <translation>Farbe und Deckkraft über der Intensität</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>Colour and opacity over gradient magnitude</source>
        <translation>Farbe und Deckkraft über dem Gradientenbetrag</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Colour and opacity over intensity and gradient</source>
        <translation>Farbe und Deckkraft über Intensität und Gradient</translation>
    </message>
    <message>
        <source>/mm</source>
        <translation>/mm</translation>
    </message>
</context>
<context>
    <name>vs::desktop::HistogramView</name>
    <message>
        <source>Drag the handles, or the band between them, to choose the displayed range.
Wheel: closer; Shift+wheel: along. Arrow keys: the band, with Ctrl its lower end, with Shift its upper end.</source>
        <translation>Griffe oder das Band dazwischen ziehen, um den angezeigten Bereich zu wählen.
Rad: näher; Umschalt+Rad: entlang. Pfeiltasten: das Band, mit Strg sein unteres Ende, mit Umschalt sein oberes.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>Geöffnet</translation>
    </message>
    <message>
        <source>Go back to after this</source>
        <translation>Zurück zum Stand nach diesem Schritt</translation>
    </message>
    <message>
        <source>Do this again</source>
        <translation>Dies noch einmal tun</translation>
    </message>
</context>
<context>
    <name>vs::desktop::IslandTool</name>
    <message>
        <source>Click a part of %1: all that is not connected to it goes. R drops parts again.</source>
        <translation>Ein Teil von %1 anklicken: alles, was nicht damit verbunden ist, fällt weg. R verwirft wieder Teile.</translation>
    </message>
    <message>
        <source>Click a part of %1 to drop it, with all that is connected to it. R keeps only the part clicked.</source>
        <translation>Ein Teil von %1 anklicken: es fällt mit allem, was damit verbunden ist, weg. R behält nur das angeklickte.</translation>
    </message>
    <message>
        <source>%1 is empty: there is no part of it to click.</source>
        <translation>%1 ist leer: kein Teil davon lässt sich anklicken.</translation>
    </message>
    <message>
        <source>Let go to keep only the part under the ring. Esc changes nothing.</source>
        <translation>Loslassen behält nur den Teil unter dem Ring. Esc ändert nichts.</translation>
    </message>
    <message>
        <source>Let go to drop the part under the ring. Esc changes nothing.</source>
        <translation>Loslassen verwirft den Teil unter dem Ring. Esc ändert nichts.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::KeepTool</name>
    <message>
        <source>Click the object to keep: all that is visible and not connected to it is cut away.</source>
        <translation>Das Objekt anklicken, das bleiben soll: alles Sichtbare, das nicht damit verbunden ist, wird weggeschnitten.</translation>
    </message>
    <message>
        <source>Let go to cut away all that is not connected to what is under the ring. Esc changes nothing.</source>
        <translation>Loslassen schneidet alles weg, was nicht mit dem unter dem Ring verbunden ist. Esc ändert nichts.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::LaserTool</name>
    <message>
        <source>The mask lies on the surface under the pen. Press and move to build it up again. Esc clears it for a new shape.</source>
        <translation>Die Maske liegt unter dem Stift auf der Oberfläche. Drücken und bewegen baut sie wieder auf. Esc löscht sie für eine neue Form.</translation>
    </message>
    <message>
        <source>Building up: press harder for more. Let go to keep, Esc to undo.</source>
        <translation>Baut auf: fester drücken für mehr. Loslassen behält, Esc macht rückgängig.</translation>
    </message>
    <message>
        <source>The mask lies on the surface under the pen. Press and move to burn. Esc clears it for a new shape.</source>
        <translation>Die Maske liegt unter dem Stift auf der Oberfläche. Drücken und bewegen brennt. Esc löscht sie für eine neue Form.</translation>
    </message>
    <message>
        <source>Burning: press harder to go deeper. Let go to keep, Esc to undo.</source>
        <translation>Brennt: fester drücken geht tiefer. Loslassen behält, Esc macht rückgängig.</translation>
    </message>
    <message>
        <source>Draw the shape of the laser anywhere.</source>
        <translation>Die Form des Lasers irgendwo zeichnen.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::MainWindow</name>
    <message>
        <source>Volume Studio</source>
        <translation>Volume Studio</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>Start screen</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>Was als Nächstes zu tun ist</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Value and place under the pen</source>
        <translation>Wert und Stelle unter dem Stift</translation>
    </message>
    <message>
        <source>Size and type of the volume</source>
        <translation>Größe und Typ des Volumens</translation>
    </message>
    <message>
        <source>Graphics device</source>
        <translation>Grafikgerät</translation>
    </message>
    <message>
        <source> – Volume Studio</source>
        <translation> – Volume Studio</translation>
    </message>
    <message>
        <source>%1 × %2 × %3  %4</source>
        <translation>%1 × %2 × %3  %4</translation>
    </message>
    <message>
        <source>Please wait…</source>
        <translation>Bitte warten…</translation>
    </message>
    <message>
        <source>nothing under the pen</source>
        <translation>nichts unter dem Stift</translation>
    </message>
    <message>
        <source>%1   at %2, %3, %4   %5</source>
        <translation>%1   bei %2, %3, %4   %5</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open a volume or a session</source>
        <translation>Ein Volumen oder eine Sitzung öffnen</translation>
    </message>
    <message>
        <source>DICOM</source>
        <translation>DICOM</translation>
    </message>
    <message>
        <source>Open a folder of DICOM slices</source>
        <translation>Einen Ordner mit DICOM-Schichten öffnen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>Open label map…</source>
        <translation>Labelkarte öffnen…</translation>
    </message>
    <message>
        <source>Make segments of the labels of a label map on the volume&apos;s grid</source>
        <translation>Aus den Labels einer Labelkarte auf dem Gitter des Volumens Segmente machen</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Close this and go back to the start screen</source>
        <translation>Schließen und zurück zur Startseite</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Save the session: everything done so far, to go on or replay</source>
        <translation>Die Sitzung speichern: alles bisher Getane, zum Weiterarbeiten oder Nachspielen</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Export the segmentation as a label map</source>
        <translation>Die Segmentierung als Labelkarte exportieren</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Save the picture as PNG, at full quality</source>
        <translation>Das Bild als PNG speichern, in voller Qualität</translation>
    </message>
    <message>
        <source>F12</source>
        <translation>F12</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Leave Volume Studio</source>
        <translation>Volume Studio verlassen</translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation>Ctrl+Q</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Take the last change back</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>Ctrl+Z</source>
        <translation>Ctrl+Z</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Noch einmal tun</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>All steps, to go to any of them</source>
        <translation>Alle Schritte, um zu jedem davon zu gehen</translation>
    </message>
    <message>
        <source>Ctrl+H</source>
        <translation>Ctrl+H</translation>
    </message>
    <message>
        <source>Un-Cut</source>
        <translation>Aufheben</translation>
    </message>
    <message>
        <source>Clear all cuts</source>
        <translation>Alle Schnitte aufheben</translation>
    </message>
    <message>
        <source>Ctrl+Shift+U</source>
        <translation>Ctrl+Shift+U</translation>
    </message>
    <message>
        <source>Re-Seed</source>
        <translation>Neu säen</translation>
    </message>
    <message>
        <source>Clear the segmentation</source>
        <translation>Die Segmentierung leeren</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Look at the face again, all of it</source>
        <translation>Wieder alles von vorn ansehen</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>The surface of the displayed range</source>
        <translation>Die Oberfläche des angezeigten Bereichs</translation>
    </message>
    <message>
        <source>MIP</source>
        <translation>MIP</translation>
    </message>
    <message>
        <source>The greatest value along each ray</source>
        <translation>Der größte Wert entlang jedes Strahls</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgen</translation>
    </message>
    <message>
        <source>The sum of the values along each ray</source>
        <translation>Die Summe der Werte entlang jedes Strahls</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Overlay</translation>
    </message>
    <message>
        <source>The segmentation in an X-ray of the rest</source>
        <translation>Die Segmentierung in einem Röntgenbild des Übrigen</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>The segmentation and the surface around it</source>
        <translation>Die Segmentierung und die Oberfläche darum</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Everything that the transfer function shows, seen through</source>
        <translation>Alles, was die Transferfunktion zeigt, durchscheinend</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>What remains after cutting</source>
        <translation>Was nach dem Schneiden bleibt</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>What has been cut out</source>
        <translation>Was herausgeschnitten wurde</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Ganz</translation>
    </message>
    <message>
        <source>The whole volume, without cuts</source>
        <translation>Das ganze Volumen, ohne Schnitte</translation>
    </message>
    <message>
        <source>Smooth sampling</source>
        <translation>Glatte Abtastung</translation>
    </message>
    <message>
        <source>Tricubic instead of trilinear: no facets where the picture is enlarged, but slower</source>
        <translation>Trikubisch statt trilinear: keine Facetten in der Vergrößerung, aber langsamer</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Ambient occlusion and soft shadows</source>
        <translation>Umgebungsverdeckung und weiche Schatten</translation>
    </message>
    <message>
        <source>Annotations</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Scale bar and orientation marker over the view; saved pictures have none</source>
        <translation>Maßstab und Richtungswürfel über der Ansicht; gespeicherte Bilder haben keine</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder Pause</translation>
    </message>
    <message>
        <source>Let the region grow, or pause it</source>
        <translation>Den Bereich wachsen lassen oder anhalten</translation>
    </message>
    <message>
        <source>Shift+G</source>
        <translation>Shift+G</translation>
    </message>
    <message>
        <source>Play backward</source>
        <translation>Rückwärts spielen</translation>
    </message>
    <message>
        <source>Play the growth backward, to its seeds</source>
        <translation>Das Wachstum rückwärts spielen, bis zur Saat</translation>
    </message>
    <message>
        <source>Shift+B</source>
        <translation>Shift+B</translation>
    </message>
    <message>
        <source>Add a segment</source>
        <translation>Segment hinzufügen</translation>
    </message>
    <message>
        <source>A fresh segment: new strokes go there</source>
        <translation>Ein frisches Segment: neue Striche gehen dorthin</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>One generation further</source>
        <translation>Eine Generation weiter</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>Backward</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>One generation back</source>
        <translation>Eine Generation zurück</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Bis zum Ende</translation>
    </message>
    <message>
        <source>Grow until nothing grows any more</source>
        <translation>Wachsen, bis nichts mehr wächst</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Segmentation</source>
        <translation>&amp;Segmentierung</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>File, view and mode</source>
        <translation>Datei, Ansicht und Modus</translation>
    </message>
    <message>
        <source>Tools and shapes</source>
        <translation>Werkzeuge und Formen</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>The mode&apos;s own</source>
        <translation>Die des Modus</translation>
    </message>
    <message>
        <source>Ivory surfaces and white rays; the volume as the displayed range has it</source>
        <translation>Elfenbeinfarbene Oberflächen und weiße Strahlen; das Volumen, wie der angezeigte Bereich es hat</translation>
    </message>
    <message>
        <source>0</source>
        <translation>0</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Aus einer Datei…</translation>
    </message>
    <message>
        <source>A transfer function as doc/transfer_functions.md describes it</source>
        <translation>Eine Transferfunktion, wie doc/transfer_functions.md sie beschreibt</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Layout of %1</source>
        <translation>Aufbau von %1</translation>
    </message>
    <message>
        <source>This file has no header. Dimensions, type and spacing:
DIMS:TYPE[:SPACING[:OFFSET]]</source>
        <translation>Diese Datei hat keinen Dateikopf. Abmessungen, Typ und Abstände:
DIMS:TYPE[:SPACING[:OFFSET]]</translation>
    </message>
    <message>
        <source>Volumes and sessions (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vtk *.dcm *.tif *.tiff *.raw *.json);;All files (*)</source>
        <translation>Volumen und Sitzungen (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vtk *.dcm *.tif *.tiff *.raw *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a label map</source>
        <translation>Labelkarte öffnen</translation>
    </message>
    <message>
        <source>Label maps (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vtk);;All files (*)</source>
        <translation>Labelkarten (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vtk);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>What is %1?</source>
        <translation>Was ist %1?</translation>
    </message>
    <message>
        <source>A label map of the open volume becomes segments of it.</source>
        <translation>Eine Labelkarte des offenen Volumens wird zu Segmenten darin.</translation>
    </message>
    <message>
        <source>&amp;Label map</source>
        <translation>&amp;Labelkarte</translation>
    </message>
    <message>
        <source>Another &amp;volume</source>
        <translation>Anderes &amp;Volumen</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Sessions (*.json)</source>
        <translation>Sitzungen (*.json)</translation>
    </message>
    <message>
        <source>Export the label map</source>
        <translation>Labelkarte exportieren</translation>
    </message>
    <message>
        <source>Label maps (*.nrrd *.nii *.nii.gz)</source>
        <translation>Labelkarten (*.nrrd *.nii *.nii.gz)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>All keys, and what the mouse does</source>
        <translation>Alle Tasten, und was die Maus tut</translation>
    </message>
    <message>
        <source>F1</source>
        <translation>F1</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>Einstellungen…</translation>
    </message>
    <message>
        <source>Theme, memory, folders, quality</source>
        <translation>Farbschema, Speicher, Ordner, Qualität</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Über</translation>
    </message>
    <message>
        <source>About Volume Studio</source>
        <translation>Über Volume Studio</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Volume Studio %1&lt;/h3&gt;&lt;p&gt;Reshape a 3D scan with a pen, on the rendered picture itself.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Volume Studio %1&lt;/h3&gt;&lt;p&gt;Formt einen 3D-Scan mit dem Stift um, auf dem gerenderten Bild selbst.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>Treiber</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>Qt</source>
        <translation>Qt</translation>
    </message>
    <message>
        <source>&lt;p&gt;Free software under the Apache licence 2.0.&lt;/p&gt;&lt;p&gt;Not a medical device: do not use it for diagnosis or treatment.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Freie Software unter der Apache-Lizenz 2.0.&lt;/p&gt;&lt;p&gt;Kein Medizinprodukt: nicht für Diagnose oder Behandlung verwenden.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Pictures…</source>
        <translation>Bilder…</translation>
    </message>
    <message>
        <source>Save the picture at any size, with scale bar or without, or a turntable of pictures</source>
        <translation>Das Bild in beliebiger Größe speichern, mit oder ohne Maßstab, oder als Bilder rundum</translation>
    </message>
    <message>
        <source>Shift+F12</source>
        <translation>Shift+F12</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>The picture as it is seen, for another program</source>
        <translation>Das Bild, wie es zu sehen ist, für ein anderes Programm</translation>
    </message>
    <message>
        <source>The picture is on the clipboard</source>
        <translation>Das Bild liegt in der Zwischenablage</translation>
    </message>
    <message>
        <source>3D only</source>
        <translation>Nur 3D</translation>
    </message>
    <message>
        <source>The 3D view alone</source>
        <translation>Die 3D-Ansicht allein</translation>
    </message>
    <message>
        <source>3D and three slices</source>
        <translation>3D und drei Schichten</translation>
    </message>
    <message>
        <source>The 3D view and three slices, all the same size</source>
        <translation>Die 3D-Ansicht und drei Schichten, alle gleich groß</translation>
    </message>
    <message>
        <source>Axial large</source>
        <translation>Axial groß</translation>
    </message>
    <message>
        <source>The axial slice large, all else beside it</source>
        <translation>Die axiale Schicht groß, alles andere daneben</translation>
    </message>
    <message>
        <source>Coronal large</source>
        <translation>Koronal groß</translation>
    </message>
    <message>
        <source>The coronal slice large, all else beside it</source>
        <translation>Die koronale Schicht groß, alles andere daneben</translation>
    </message>
    <message>
        <source>Sagittal large</source>
        <translation>Sagittal groß</translation>
    </message>
    <message>
        <source>The sagittal slice large, all else beside it</source>
        <translation>Die sagittale Schicht groß, alles andere daneben</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Axial, coronal and sagittal slices beside the 3D view</source>
        <translation>Axiale, koronale und sagittale Schichten neben der 3D-Ansicht</translation>
    </message>
    <message>
        <source>F4</source>
        <translation>F4</translation>
    </message>
    <message>
        <source>Smooth slices</source>
        <translation>Glatte Schichten</translation>
    </message>
    <message>
        <source>Slices interpolated between voxels, instead of every voxel as an area</source>
        <translation>Schichten zwischen Voxeln interpoliert, statt jedes Voxel als Fläche</translation>
    </message>
    <message>
        <source>All of each slice</source>
        <translation>Jede Schicht ganz</translation>
    </message>
    <message>
        <source>Show all of each slice again</source>
        <translation>Wieder jede Schicht ganz zeigen</translation>
    </message>
    <message>
        <source>Shift+Home</source>
        <translation>Shift+Home</translation>
    </message>
    <message>
        <source>Smaller brush</source>
        <translation>Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>A smaller brush to paint on slices with</source>
        <translation>Ein kleinerer Pinsel zum Malen auf Schichten</translation>
    </message>
    <message>
        <source>[</source>
        <translation>[</translation>
    </message>
    <message>
        <source>Larger brush</source>
        <translation>Größerer Pinsel</translation>
    </message>
    <message>
        <source>A larger brush to paint on slices with</source>
        <translation>Ein größerer Pinsel zum Malen auf Schichten</translation>
    </message>
    <message>
        <source>]</source>
        <translation>]</translation>
    </message>
    <message>
        <source>There are edits that no session file holds.</source>
        <translation>Es gibt Änderungen, die in keiner Sitzungsdatei stehen.</translation>
    </message>
    <message>
        <source>Save the session before leaving it?</source>
        <translation>Sitzung vor dem Verlassen speichern?</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern…</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>The tool&apos;s sign reversed: puts back instead of cutting, absorbs instead of seeding; hold the key for as long as you want it</source>
        <translation>Das Werkzeug umgekehrt: füllt auf statt zu schneiden, absorbiert statt zu säen; die Taste halten, solange es gelten soll</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Drop the stroke in hand, or the mask</source>
        <translation>Den begonnenen Strich oder die Maske verwerfen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Free-form</source>
        <translation>Freihand</translation>
    </message>
    <message>
        <source>Draw the outline by hand</source>
        <translation>Den Umriss von Hand zeichnen</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Drag an ellipse from corner to corner</source>
        <translation>Eine Ellipse von Ecke zu Ecke aufziehen</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Drag a circle from its centre</source>
        <translation>Einen Kreis von seiner Mitte aufziehen</translation>
    </message>
    <message>
        <source>O</source>
        <translation>O</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Drag a rectangle from corner to corner</source>
        <translation>Ein Rechteck von Ecke zu Ecke aufziehen</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Polyline</source>
        <translation>Linienzug</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>The shape that a PNG shows, bright or opaque: drag the box that it fills</source>
        <translation>Die Form, die ein PNG zeigt, hell oder deckend: den Kasten aufziehen, den sie füllt</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>A picture for the mask&apos;s shape</source>
        <translation>Ein Bild für die Form der Maske</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Surfaces, DICOM segmentations, the sculpted volume and tables, for other programs</source>
        <translation>Oberflächen, DICOM-Segmentierungen, das bearbeitete Volumen und Tabellen, für andere Programme</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>End what takes so long, and leave everything as it was (Esc)</source>
        <translation>Beendet, was so lange dauert, und lässt alles, wie es war (Esc)</translation>
    </message>
    <message>
        <source>Refining %1 %</source>
        <translation>Verfeinern %1 %</translation>
    </message>
    <message>
        <source>Frame rate; at rest, how far the picture is refined</source>
        <translation>Bildrate; in Ruhe: wie weit das Bild verfeinert ist</translation>
    </message>
    <message>
        <source>Hide above</source>
        <translation>Darüber ausblenden</translation>
    </message>
    <message>
        <source>MIP, X-ray and overlay: hide values above the displayed range, instead of showing them as its upper end</source>
        <translation>MIP, Röntgen und Overlay: Werte über dem angezeigten Bereich ausblenden, statt sie als dessen oberes Ende zu zeigen</translation>
    </message>
    <message>
        <source>Tint segments</source>
        <translation>Segmente färben</translation>
    </message>
    <message>
        <source>MIP and X-ray: what is in a segment has the segment&apos;s colour</source>
        <translation>MIP und Röntgen: Was in einem Segment liegt, hat dessen Farbe</translation>
    </message>
    <message>
        <source>Click corner after corner; Enter, a double click or the first corner ends it</source>
        <translation>Ecke um Ecke klicken; Enter, ein Doppelklick oder die erste Ecke beendet ihn</translation>
    </message>
    <message>
        <source>Note…</source>
        <translation>Notiz …</translation>
    </message>
    <message>
        <source>Write a line into the history: why something was done, what to look at</source>
        <translation>Eine Zeile in den Verlauf schreiben: warum etwas getan wurde, worauf zu achten ist</translation>
    </message>
    <message>
        <source>Ctrl+N</source>
        <translation>Ctrl+N</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>A line for the history:</source>
        <translation>Eine Zeile für den Verlauf:</translation>
    </message>
    <message>
        <source>Reload shaders</source>
        <translation>Shader neu laden</translation>
    </message>
    <message>
        <source>Read the shaders in VOLUME_STUDIO_SHADER_DIR again</source>
        <translation>Die Shader in VOLUME_STUDIO_SHADER_DIR noch einmal lesen</translation>
    </message>
    <message>
        <source>Ctrl+F5</source>
        <translation>Ctrl+F5</translation>
    </message>
    <message>
        <source>VOLUME_STUDIO_SHADER_DIR is not set: start with the folder src of the sources in it</source>
        <translation>VOLUME_STUDIO_SHADER_DIR ist nicht gesetzt: beim Start muss der Ordner src der Quellen darin stehen</translation>
    </message>
    <message>
        <source>Shaders are those in %1</source>
        <translation>Die Shader sind die in %1</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>The values of this scan from black to white</source>
        <translation>Die Werte dieser Aufnahme von Schwarz bis Weiß</translation>
    </message>
    <message>
        <source>%1 (CT)</source>
        <translation>%1 (CT)</translation>
    </message>
    <message>
        <source>CT: level %1, width %2</source>
        <translation>CT: Lage %1, Weite %2</translation>
    </message>
    <message>
        <source>Tint what is shown</source>
        <translation>Gezeigtes einfärben</translation>
    </message>
    <message>
        <source>Slices show in colour what the 3D picture shows: the displayed range or the transfer function</source>
        <translation>Schichten zeigen in Farbe, was das 3D-Bild zeigt: den angezeigten Bereich oder die Transferfunktion</translation>
    </message>
    <message>
        <source>Shift+W</source>
        <translation>Shift+W</translation>
    </message>
    <message>
        <source>Window of slices</source>
        <translation>Fenster der Schichten</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show all that can be seen as large as there is room for</source>
        <translation>Alles, was zu sehen ist, so groß zeigen, wie Platz ist</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>Orthografisch</translation>
    </message>
    <message>
        <source>Without perspective: what is farther off is as large</source>
        <translation>Ohne Perspektive: was weiter weg ist, ist ebenso groß</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>The head stays up while the volume is turned, instead of rolling under the hand</source>
        <translation>Der Kopf bleibt oben, wenn gedreht wird, statt unter der Hand zu rollen</translation>
    </message>
    <message>
        <source>Look from</source>
        <translation>Ansicht von</translation>
    </message>
    <message>
        <source>Back to before the leak</source>
        <translation>Zurück vor das Leck</translation>
    </message>
    <message>
        <source>Show the last generation before the region may have leaked (marked on the scrub bar)</source>
        <translation>Die letzte Generation zeigen, bevor die Region ausgelaufen sein kann (auf der Leiste markiert)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>Properties…</source>
        <translation>Eigenschaften…</translation>
    </message>
    <message>
        <source>File, patient, size, spacing, orientation and values of the volume, and what was unusual about its files</source>
        <translation>Datei, Patient, Größe, Abstände, Ausrichtung und Werte des Volumens, und was an seinen Dateien ungewöhnlich war</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>How long the last step took</source>
        <translation>Wie lange der letzte Schritt gedauert hat</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Sculpt from nothing…</source>
        <translation>Aus dem Nichts formen…</translation>
    </message>
    <message>
        <source>A block of a chosen size, to be carved or built up</source>
        <translation>Ein Block von gewählter Größe, aus dem man schnitzt oder den man aufbaut</translation>
    </message>
    <message>
        <source>Ctrl+Alt+N</source>
        <translation>Ctrl+Alt+N</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>End growing: what has grown stays</source>
        <translation>Das Wachsen beenden: Was gewachsen ist, bleibt</translation>
    </message>
    <message>
        <source>Ctrl+.</source>
        <translation>Ctrl+.</translation>
    </message>
    <message>
        <source>Drag to turn</source>
        <translation>Ziehen dreht</translation>
    </message>
    <message>
        <source>The camera tool turns the volume</source>
        <translation>Das Kamerawerkzeug dreht das Volumen</translation>
    </message>
    <message>
        <source>Drag to move</source>
        <translation>Ziehen verschiebt</translation>
    </message>
    <message>
        <source>The camera tool moves the picture</source>
        <translation>Das Kamerawerkzeug verschiebt das Bild</translation>
    </message>
    <message>
        <source>Drag to zoom</source>
        <translation>Ziehen zoomt</translation>
    </message>
    <message>
        <source>The camera tool comes nearer and steps back</source>
        <translation>Das Kamerawerkzeug holt heran und geht zurück</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Invertieren</translation>
    </message>
    <message>
        <source>MIP and X-ray: dark on light, as PET is often read; colours stay</source>
        <translation>MIP und Röntgen: dunkel auf hell, wie PET oft befundet wird; Farben bleiben</translation>
    </message>
    <message>
        <source>Pull Out</source>
        <translation>Herausziehen</translation>
    </message>
    <message>
        <source>Draw the segment at work once more beside the object, to be moved by hand; it stays in its place too. Again: no more</source>
        <translation>Zeichnet das aktive Segment noch einmal neben das Objekt, von Hand zu verschieben; es bleibt auch an seinem Platz. Noch einmal: nicht mehr</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Play a session…</source>
        <translation>Sitzung abspielen…</translation>
    </message>
    <message>
        <source>Open a session and see it done step by step, as it was drawn</source>
        <translation>Eine Sitzung öffnen und zusehen, wie sie Schritt für Schritt gezeichnet wurde</translation>
    </message>
    <message>
        <source>Ctrl+Alt+O</source>
        <translation>Ctrl+Alt+O</translation>
    </message>
    <message>
        <source>Play from the start</source>
        <translation>Von Anfang an abspielen</translation>
    </message>
    <message>
        <source>See all that was done to this scan once more, step by step</source>
        <translation>Alles, was mit diesem Scan getan wurde, noch einmal sehen, Schritt für Schritt</translation>
    </message>
    <message>
        <source>Ctrl+Alt+P</source>
        <translation>Ctrl+Alt+P</translation>
    </message>
    <message>
        <source>Play or pause the session</source>
        <translation>Sitzung abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Let the session go on, or hold it</source>
        <translation>Die Sitzung weiterlaufen lassen oder anhalten</translation>
    </message>
    <message>
        <source>Play a session</source>
        <translation>Sitzung abspielen</translation>
    </message>
    <message>
        <source>Paste what tools cut since the last paste beside the object, to be moved by hand</source>
        <translation>Was Werkzeuge seit dem letzten Einfügen ausgeschnitten haben, neben dem Objekt einfügen, um es von Hand zu bewegen</translation>
    </message>
    <message>
        <source>Paste All</source>
        <translation>Alles einfügen</translation>
    </message>
    <message>
        <source>Paste what was cut since the last paste, also what Keep and Clip took away</source>
        <translation>Alles einfügen, was seit dem letzten Einfügen weggeschnitten wurde, auch was Behalten und Beschneiden weggenommen haben</translation>
    </message>
    <message>
        <source>Ctrl+Alt+V</source>
        <translation>Ctrl+Alt+V</translation>
    </message>
    <message>
        <source>Segments as voxels</source>
        <translation>Segmente als Voxel</translation>
    </message>
    <message>
        <source>Segments voxel by voxel, as they grow, instead of smooth</source>
        <translation>Segmente Voxel für Voxel, wie sie wachsen, statt glatt</translation>
    </message>
    <message>
        <source>Where is %1, the scan of %2?</source>
        <translation>Wo ist %1, der Scan von %2?</translation>
    </message>
    <message>
        <source>Volumes (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vtk *.dcm *.tif *.tiff *.raw);;All files (*)</source>
        <translation>Volumen (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vtk *.dcm *.tif *.tiff *.raw);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Save the session in another file</source>
        <translation>Die Sitzung in einer anderen Datei speichern</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Film…</source>
        <translation>Film…</translation>
    </message>
    <message>
        <source>A film around what is seen, of its growth, of all that was done, or from view to view</source>
        <translation>Ein Film rund um das Sichtbare, vom Wachsen, von allem, was getan wurde, oder von Ansicht zu Ansicht</translation>
    </message>
    <message>
        <source>Ctrl+F12</source>
        <translation>Ctrl+F12</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Where is %1, the scan of what was lost?</source>
        <translation>Wo ist %1, die Aufnahme zu den verlorenen Änderungen?</translation>
    </message>
    <message>
        <source>Click to save the session (Ctrl+S)</source>
        <translation>Klicken, um die Sitzung zu speichern (Strg+S)</translation>
    </message>
    <message>
        <source>It is being recovered in another window</source>
        <translation>Sie wird in einem anderen Fenster wiederhergestellt</translation>
    </message>
    <message>
        <source>No crash journal</source>
        <translation>Kein Absturzprotokoll</translation>
    </message>
    <message>
        <source>The graphics driver was reset.</source>
        <translation>Der Grafiktreiber wurde zurückgesetzt.</translation>
    </message>
    <message>
        <source>What you have done is kept. Volume Studio starts again and offers to go on with it.</source>
        <translation>Was Sie getan haben, ist aufgehoben. Volume Studio startet neu und bietet an, damit weiterzumachen.</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>&amp;Neu starten</translation>
    </message>
    <message>
        <source>  level %1</source>
        <translation>  Stufe %1</translation>
    </message>
    <message>
        <source>Edits are made on level %1. Pictures at rest show up to %2 × %3 × %4 voxels.</source>
        <translation>Bearbeitet wird auf Stufe %1. Ruhende Bilder zeigen bis zu %2 × %3 × %4 Voxel.</translation>
    </message>
    <message>
        <source>Reading bricks: %1</source>
        <translation>Blöcke lesen: %1</translation>
    </message>
</context>
<context>
    <name>vs::desktop::MarkTool</name>
    <message>
        <source>Erasing: let go to keep, Esc to undo.</source>
        <translation>Löschen: Loslassen behält es, Esc nimmt es zurück.</translation>
    </message>
    <message>
        <source>Marking: press harder for more. Let go to keep, Esc to undo.</source>
        <translation>Markieren: fester drücken für mehr. Loslassen behält es, Esc nimmt es zurück.</translation>
    </message>
    <message>
        <source>Click where the letters should be wiped off.</source>
        <translation>Klicken, wo die Buchstaben weggewischt werden sollen.</translation>
    </message>
    <message>
        <source>Click where the letters should stand; they are written upright.</source>
        <translation>Klicken, wo die Buchstaben stehen sollen; sie werden aufrecht geschrieben.</translation>
    </message>
    <message>
        <source>Draw over the marks that should go.</source>
        <translation>Über die Markierungen zeichnen, die weg sollen.</translation>
    </message>
    <message>
        <source>Draw around what should be coloured.</source>
        <translation>Um das zeichnen, was eingefärbt werden soll.</translation>
    </message>
    <message>
        <source>Draw an arrow, its head at the end.</source>
        <translation>Einen Pfeil zeichnen, die Spitze am Ende.</translation>
    </message>
    <message>
        <source>Draw on the surface: the marks stay on the material.</source>
        <translation>Auf die Oberfläche zeichnen: Die Markierungen bleiben auf dem Material.</translation>
    </message>
    <message>
        <source>Type the letters first, on the tool&apos;s page.</source>
        <translation>Zuerst die Buchstaben eingeben, auf der Seite des Werkzeugs.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::MeasureTool</name>
    <message>
        <source>Click three places, on the surface or on a slice: the angle is the one at the second.</source>
        <translation>Drei Stellen anklicken, auf der Oberfläche oder auf einer Schicht: der Winkel ist der an der zweiten.</translation>
    </message>
    <message>
        <source>Click two places, on the surface or on a slice, or drag from one to the other.</source>
        <translation>Zwei Stellen anklicken, auf der Oberfläche oder auf einer Schicht, oder von einer zur anderen ziehen.</translation>
    </message>
    <message>
        <source>Turning the view: there is no surface where the drag began.</source>
        <translation>Die Ansicht dreht sich: wo das Ziehen begann, ist keine Oberfläche.</translation>
    </message>
    <message>
        <source>Drag to the second place, or let go and click it. Esc drops the measurement.</source>
        <translation>Zur zweiten Stelle ziehen, oder loslassen und sie anklicken. Esc verwirft die Messung.</translation>
    </message>
    <message>
        <source>Let go to measure to here. Esc drops the measurement.</source>
        <translation>Loslassen misst bis hierher. Esc verwirft die Messung.</translation>
    </message>
    <message>
        <source>Click the second place. Esc drops the measurement.</source>
        <translation>Die zweite Stelle anklicken. Esc verwirft die Messung.</translation>
    </message>
    <message>
        <source>Click the third place. Esc drops the measurement.</source>
        <translation>Die dritte Stelle anklicken. Esc verwirft die Messung.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Turning the view: areas are drawn on slices.</source>
        <translation>Die Ansicht wird gedreht: Flächen werden auf Schnitten gezeichnet.</translation>
    </message>
    <message>
        <source>Draw along it, and let go at its end. Esc drops the measurement.</source>
        <translation>Daran entlang zeichnen und am Ende loslassen. Esc verwirft die Messung.</translation>
    </message>
    <message>
        <source>Draw around it, and let go to close the outline. Esc drops it.</source>
        <translation>Darum herum zeichnen und loslassen, um den Umriss zu schließen. Esc verwirft ihn.</translation>
    </message>
    <message>
        <source>Draw along what is to be measured, on the surface or on a slice.</source>
        <translation>Auf der Oberfläche oder auf einem Schnitt an dem entlang zeichnen, was gemessen werden soll.</translation>
    </message>
    <message>
        <source>Draw around what is to be measured, on a slice: an area lies in one.</source>
        <translation>Auf einem Schnitt um das herum zeichnen, was gemessen werden soll: Eine Fläche liegt in einem Schnitt.</translation>
    </message>
    <message>
        <source>Click two places along a segment that is a vessel, on the surface or on a slice.</source>
        <translation>Zwei Stellen entlang eines Segments anklicken, das ein Gefäß ist, auf der Oberfläche oder in einem Schnittbild.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::MoveTool</name>
    <message>
        <source>Turning the view. Press on the part to move that.</source>
        <translation>Dreht die Ansicht. Auf das Teil drücken, um es zu bewegen.</translation>
    </message>
    <message>
        <source>Drag the part to move it, with Shift to turn it, with Ctrl to roll it; the wheel scales it.</source>
        <translation>Das Teil ziehen, um es zu bewegen, mit Umschalt zu drehen, mit Strg zu rollen; das Rad skaliert es.</translation>
    </message>
    <message>
        <source> Tab: the next part.</source>
        <translation> Tab: das nächste Teil.</translation>
    </message>
    <message>
        <source>Let go to leave the part there. Esc puts it back.</source>
        <translation>Loslassen lässt den Teil dort. Esc bringt ihn zurück.</translation>
    </message>
    <message>
        <source>Nothing to move: paste what was cut (Shift+V) or pull a segment out (Ctrl+Shift+V).</source>
        <translation>Nichts zu bewegen: Ausgeschnittenes einfügen (Umschalt+V) oder ein Segment herausziehen (Strg+Umschalt+V).</translation>
    </message>
    <message>
        <source>Its size</source>
        <translation>Seine Größe</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>With what Keep and Clip took</source>
        <translation>Mit dem, was Behalten und Beschneiden nahmen</translation>
    </message>
    <message>
        <source>What they took away around the part belongs to it too</source>
        <translation>Was sie um das Teil herum weggenommen haben, gehört auch dazu</translation>
    </message>
    <message>
        <source>Back to its own place</source>
        <translation>Zurück an den eigenen Ort</translation>
    </message>
    <message>
        <source>Put the part back to where it was cut out or lies</source>
        <translation>Das Teil dorthin zurücksetzen, wo es ausgeschnitten wurde oder liegt</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Draw it no more</source>
        <translation>Nicht mehr zeichnen</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Pull all segments out</source>
        <translation>Alle Segmente herausziehen</translation>
    </message>
    <message>
        <source>Each in its own place, to be moved apart; again: put them all back</source>
        <translation>Jedes an seinem Ort, um sie auseinanderzurücken; noch einmal: alle zurücksetzen</translation>
    </message>
    <message>
        <source>How far parts are moved apart from the middle</source>
        <translation>Wie weit Teile von der Mitte aus auseinanderrücken</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Auseinander</translation>
    </message>
    <message>
        <source>Put all segments back</source>
        <translation>Alle Segmente zurücksetzen</translation>
    </message>
</context>
<context>
    <name>vs::desktop::NoticesBadge</name>
    <message>
        <source>Notices of reading</source>
        <translation>Hinweise vom Lesen</translation>
    </message>
    <message>
        <source>Click to read what was unusual about the file (Ctrl+I)</source>
        <translation>Klicken, um zu lesen, was an der Datei ungewöhnlich war (Ctrl+I)</translation>
    </message>
    <message>
        <source>Notices: %1</source>
        <translation>Hinweise: %1</translation>
    </message>
</context>
<context>
    <name>vs::desktop::PaintTool</name>
    <message>
        <source>Paint on a slice to add to the segment; the right button or Ctrl removes. [ and ] change the brush, Shift leads the crosshair.</source>
        <translation>Auf einer Schicht malen, um zum Segment hinzuzufügen; rechte Taste oder Strg entfernt. [ und ] ändern den Pinsel, Umschalt führt das Fadenkreuz.</translation>
    </message>
    <message>
        <source>Paint on a slice to remove from the segment; the right button or Ctrl adds. [ and ] change the brush, Shift leads the crosshair.</source>
        <translation>Auf einer Schicht malen, um aus dem Segment zu entfernen; rechte Taste oder Strg fügt hinzu. [ und ] ändern den Pinsel, Umschalt führt das Fadenkreuz.</translation>
    </message>
    <message>
        <source>Painting goes on the slices: show them with F4. Here dragging turns the volume.</source>
        <translation>Gemalt wird auf den Schichten: F4 zeigt sie. Hier dreht Ziehen das Volumen.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::PartList</name>
    <message>
        <source>Parts and segments that are pulled out</source>
        <translation>Teile und herausgezogene Segmente</translation>
    </message>
    <message>
        <source>The box says whether it is seen; F2 or a double click renames, Delete discards</source>
        <translation>Das Kästchen sagt, ob es zu sehen ist; F2 oder ein Doppelklick benennt um, Entf verwirft</translation>
    </message>
    <message>
        <source>A part needs a name</source>
        <translation>Ein Teil braucht einen Namen</translation>
    </message>
    <message>
        <source>A part&apos;s name has at most %1 characters</source>
        <translation>Der Name eines Teils hat höchstens %1 Zeichen</translation>
    </message>
</context>
<context>
    <name>vs::desktop::PeelTool</name>
    <message>
        <source>Press inside the mask and drag down to put layers back on. Draw outside it for a new mask. Esc clears it.</source>
        <translation>In die Maske drücken und nach unten ziehen legt Lagen wieder auf. Außerhalb zeichnen für eine neue Maske. Esc löscht sie.</translation>
    </message>
    <message>
        <source>Press inside the mask and drag down to peel. Draw outside it for a new mask. Esc clears it.</source>
        <translation>In der Maske nach unten ziehen schält. Außerhalb: neue Maske. Esc löscht sie.</translation>
    </message>
    <message>
        <source>Down puts back, up takes off: %1 layers. Let go to keep, Esc to undo.</source>
        <translation>Nach unten füllt auf, nach oben nimmt weg: %1 Lagen. Loslassen behält, Esc macht rückgängig.</translation>
    </message>
    <message>
        <source>Down peels, up puts back: %1 layers. Let go to keep, Esc to undo.</source>
        <translation>Nach unten schält, nach oben legt auf: %1 Lagen. Loslassen behält, Esc macht rückgängig.</translation>
    </message>
    <message>
        <source>Draw an outline around the region to peel.</source>
        <translation>Einen Umriss um das zeichnen, was geschält werden soll.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::PictureDialog</name>
    <message>
        <source>Save pictures</source>
        <translation>Bilder speichern</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>Wie im Fenster</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparent</translation>
    </message>
    <message>
        <source>Scale bar and orientation marker</source>
        <translation>Maßstab und Richtungswürfel</translation>
    </message>
    <message>
        <source>Draws both into the picture</source>
        <translation>Zeichnet beide ins Bild</translation>
    </message>
    <message>
        <source>Pictures all the way around</source>
        <translation>Bilder ringsherum</translation>
    </message>
    <message>
        <source>one picture, as seen</source>
        <translation>ein Bild, wie zu sehen</translation>
    </message>
    <message>
        <source> pictures around</source>
        <translation> Bilder ringsum</translation>
    </message>
    <message>
        <source>More than one: a turntable, as numbered files for a film</source>
        <translation>Mehr als eines: eine Runde, als nummerierte Dateien für einen Film</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Rundum</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Breite in Pixeln</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>Höhe in Pixeln</translation>
    </message>
    <message>
        <source>by</source>
        <translation>mal</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>The shape of the view</source>
        <translation>Die Form der Ansicht</translation>
    </message>
    <message>
        <source>Width and height go together</source>
        <translation>Breite und Höhe gehen zusammen</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
</context>
<context>
    <name>vs::desktop::PictureExport</name>
    <message>
        <source>The document changed: the pictures were given up</source>
        <translation>Das Dokument hat sich geändert: die Bilder wurden aufgegeben</translation>
    </message>
    <message>
        <source>Saved %1 pictures up to %2</source>
        <translation>%1 Bilder bis %2 gespeichert</translation>
    </message>
    <message>
        <source>Saved picture %1</source>
        <translation>Bild %1 gespeichert</translation>
    </message>
    <message>
        <source>Given up after %1 of %2 pictures</source>
        <translation>Aufgegeben nach %1 von %2 Bildern</translation>
    </message>
</context>
<context>
    <name>vs::desktop::PlaneView</name>
    <message>
        <source>gradient up to %1 per mm</source>
        <translation>Gradient bis %1 je mm</translation>
    </message>
</context>
<context>
    <name>vs::desktop::PlayStrip</name>
    <message>
        <source>What is done in this step</source>
        <translation>Was in diesem Schritt getan wird</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play on (Space)</source>
        <translation>Weiter abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>One step</source>
        <translation>Ein Schritt</translation>
    </message>
    <message>
        <source>Play one step, then pause</source>
        <translation>Einen Schritt abspielen, dann anhalten</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Back to where this step began, or the one before</source>
        <translation>Zurück zum Anfang dieses Schritts oder des vorigen</translation>
    </message>
    <message>
        <source>How fast</source>
        <translation>Wie schnell</translation>
    </message>
    <message>
        <source>Steps of the session</source>
        <translation>Schritte der Sitzung</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Go on by hand</source>
        <translation>Von Hand weiter</translation>
    </message>
    <message>
        <source>End playing: what was done so far stays, and is yours</source>
        <translation>Abspielen beenden: was bisher getan wurde, bleibt</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>That was all.</source>
        <translation>Das war alles.</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Anhalten (Leertaste)</translation>
    </message>
</context>
<context>
    <name>vs::desktop::PlayTool</name>
    <message>
        <source>Playing. Click, or press Space, to pause; take any tool to go on by hand.</source>
        <translation>Läuft. Klick oder Leertaste hält an; jedes Werkzeug nehmen, um von Hand fortzufahren.</translation>
    </message>
    <message>
        <source>All is done. Go on by hand with any tool, or go back to a step.</source>
        <translation>Alles ist getan. Mit einem Werkzeug von Hand fortfahren oder zu einem Schritt zurück.</translation>
    </message>
    <message>
        <source>Paused. Space plays on. Drag to turn the picture; take any tool to go on by hand.</source>
        <translation>Angehalten. Leertaste: weiter. Ziehen dreht das Bild; jedes Werkzeug nehmen, um von Hand fortzufahren.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>The picture is the brightest thing</source>
        <translation>Das Bild ist das Hellste</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>For bright rooms</source>
        <translation>Für helle Räume</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>Dark or light as other windows are</source>
        <translation>Dunkel oder hell wie andere Fenster</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>German where the desktop speaks it, else English</source>
        <translation>Deutsch, wo der Desktop es spricht, sonst Englisch</translation>
    </message>
    <message>
        <source>English, whatever the desktop speaks</source>
        <translation>Englisch, was auch immer der Desktop spricht</translation>
    </message>
    <message>
        <source>German, whatever the desktop speaks</source>
        <translation>Deutsch, was auch immer der Desktop spricht</translation>
    </message>
    <message>
        <source>Start Volume Studio again to read it in the other language.</source>
        <translation>Volume Studio neu starten, um es in der anderen Sprache zu lesen.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation>Speicher für Rückgängig</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Undo has no end; what does not fit goes to a temporary file</source>
        <translation>Rückgängig hat kein Ende; was nicht hineinpasst, kommt in eine temporäre Datei</translation>
    </message>
    <message>
        <source>Folder to save in</source>
        <translation>Ordner zum Speichern</translation>
    </message>
    <message>
        <source>Where the file dialog was last</source>
        <translation>Wo der Dateidialog zuletzt war</translation>
    </message>
    <message>
        <source>Where sessions, pictures and label maps are saved unless another folder is chosen</source>
        <translation>Wohin Sitzungen, Bilder und Labelkarten gespeichert werden, wenn kein anderer Ordner gewählt wird</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder to save in</source>
        <translation>Den Ordner zum Speichern wählen</translation>
    </message>
    <message>
        <source>Recordings go to</source>
        <translation>Gespeichert wird in</translation>
    </message>
    <message>
        <source>Smooth sampling</source>
        <translation>Glatte Abtastung</translation>
    </message>
    <message>
        <source>Tricubic instead of trilinear: no facets where the picture is enlarged</source>
        <translation>Trikubisch statt trilinear: keine Facetten in der Vergrößerung</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Ambient occlusion and soft shadows</source>
        <translation>Umgebungsverdeckung und weiche Schatten</translation>
    </message>
    <message>
        <source>Volumes open with</source>
        <translation>Volumen öffnen mit</translation>
    </message>
    <message>
        <source>Window of CT slices</source>
        <translation>Fenster von CT-Schichten</translation>
    </message>
    <message>
        <source>The values that slices of CT scans show from black to white when they are opened</source>
        <translation>Die Werte, die Schichten von CT-Aufnahmen beim Öffnen von Schwarz bis Weiß zeigen</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Tint what is shown</source>
        <translation>Gezeigtes einfärben</translation>
    </message>
    <message>
        <source>Slices show in colour what the 3D picture shows</source>
        <translation>Schichten zeigen in Farbe, was das 3D-Bild zeigt</translation>
    </message>
    <message>
        <source>Slices of CT scans</source>
        <translation>Schichten von CT-Aufnahmen</translation>
    </message>
    <message>
        <source>All slices</source>
        <translation>Alle Schichten</translation>
    </message>
    <message>
        <source>Graphics memory for scans</source>
        <translation>Grafikspeicher für Scans</translation>
    </message>
    <message>
        <source>What scans and edits may take on the graphics device, from the next scan that is opened on. Larger ones are worked on at a coarser level</source>
        <translation>Was Scans und ihre Bearbeitung auf dem Grafikgerät belegen dürfen, vom nächsten geöffneten Scan an. Größere werden auf einer gröberen Stufe bearbeitet</translation>
    </message>
    <message>
        <source>Memory for large scans</source>
        <translation>Speicher für große Scans</translation>
    </message>
    <message>
        <source>What parts of large scans that were read, and growth in them, may take, from the next scan that is opened on</source>
        <translation>Was gelesene Teile großer Scans und Wachstum darin belegen dürfen, vom nächsten geöffneten Scan an</translation>
    </message>
</context>
<context>
    <name>vs::desktop::PropertiesDialog</name>
    <message>
        <source>Properties of the volume</source>
        <translation>Eigenschaften des Volumens</translation>
    </message>
    <message>
        <source>Notices of reading</source>
        <translation>Hinweise vom Lesen</translation>
    </message>
    <message>
        <source>Notice</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>There are none: the file was read as it is.</source>
        <translation>Keine: Die Datei wurde gelesen, wie sie ist.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy all of it as text</source>
        <translation>Alles als Text kopieren</translation>
    </message>
</context>
<context>
    <name>vs::desktop::RangePage</name>
    <message>
        <source>Histogram with the displayed range</source>
        <translation>Histogramm mit dem angezeigten Bereich</translation>
    </message>
    <message>
        <source>What is wrong with the number that was typed</source>
        <translation>Was an der getippten Zahl nicht stimmt</translation>
    </message>
    <message>
        <source>Lower end of the displayed range</source>
        <translation>Unteres Ende des angezeigten Bereichs</translation>
    </message>
    <message>
        <source>Upper end of the displayed range</source>
        <translation>Oberes Ende des angezeigten Bereichs</translation>
    </message>
    <message>
        <source>Unit of the volume&apos;s values</source>
        <translation>Einheit der Werte des Volumens</translation>
    </message>
    <message>
        <source>Logarithmic counts</source>
        <translation>Logarithmische Anzahlen</translation>
    </message>
    <message>
        <source>log</source>
        <translation>log</translation>
    </message>
    <message>
        <source>Heights by the logarithm of the counts: few voxels show beside millions of others</source>
        <translation>Höhen nach dem Logarithmus der Anzahlen: wenige Voxel sind neben Millionen anderer zu sehen</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>The ends are exchanged: the lower one comes first.</source>
        <translation>Die Enden sind vertauscht: das untere kommt zuerst.</translation>
    </message>
    <message>
        <source>%1 lies beyond the data, which go from %2 to %3.</source>
        <translation>%1 liegt außerhalb der Daten, die von %2 bis %3 gehen.</translation>
    </message>
    <message>
        <source>%1 of %2 voxels visible</source>
        <translation>%1 von %2 Voxeln sichtbar</translation>
    </message>
    <message>
        <source>Smoothing of the displayed surface, in steps</source>
        <translation>Glättung der angezeigten Oberfläche, in Schritten</translation>
    </message>
    <message>
        <source>Smooths the values before the surface is looked for: takes the grain off skin. Sections show the values as they are.</source>
        <translation>Glättet die Werte, bevor die Oberfläche gesucht wird: nimmt Haut die Maserung. Schnittflächen zeigen die Werte, wie sie sind.</translation>
    </message>
    <message>
        <source>Smooth surface</source>
        <translation>Oberfläche glätten</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
</context>
<context>
    <name>vs::desktop::RecoveryKeeper</name>
    <message>
        <source>The crash journal goes on</source>
        <translation>Das Absturzprotokoll wird wieder geführt</translation>
    </message>
</context>
<context>
    <name>vs::desktop::RecoveryList</name>
    <message>
        <source>Discard…</source>
        <translation>Verwerfen…</translation>
    </message>
    <message>
        <source>Discard the edits of %1</source>
        <translation>Die Änderungen an %1 verwerfen</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Recover the edits of %1</source>
        <translation>Die Änderungen an %1 wiederherstellen</translation>
    </message>
    <message>
        <source>Volume Studio</source>
        <translation>Volume Studio</translation>
    </message>
    <message>
        <source>Discard the edits of %1 for good?</source>
        <translation>Die Änderungen an %1 endgültig verwerfen?</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>Find and recover…</source>
        <translation>Suchen und wiederherstellen…</translation>
    </message>
</context>
<context>
    <name>vs::desktop::SavingDialog</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>vs::desktop::ScissorsTool</name>
    <message>
        <source>Draw around a region: the scissors take everything outside it.</source>
        <translation>Um eine Stelle zeichnen: die Schere nimmt alles außerhalb.</translation>
    </message>
    <message>
        <source>Draw around what the scissors should take.</source>
        <translation>Um das zeichnen, was die Schere nehmen soll.</translation>
    </message>
    <message>
        <source>Draw around a region: everything outside it is put back.</source>
        <translation>Um eine Stelle zeichnen: alles außerhalb wird aufgefüllt.</translation>
    </message>
    <message>
        <source>Draw around what should be put back.</source>
        <translation>Um das zeichnen, was aufgefüllt werden soll.</translation>
    </message>
    <message>
        <source>Draw around what should stay: everything outside it is cut.</source>
        <translation>Um das zeichnen, was bleiben soll: alles außerhalb wird geschnitten.</translation>
    </message>
    <message>
        <source>Draw around what should go.</source>
        <translation>Um das zeichnen, was weg soll.</translation>
    </message>
    <message>
        <source>Draw around the material that should go.</source>
        <translation>Um das Material zeichnen, das weg soll.</translation>
    </message>
    <message>
        <source>Draw around a hole, on the surface beside it: it is filled up to that.</source>
        <translation>Um ein Loch zeichnen, auf der Oberfläche daneben: Es wird bis zu dieser gefüllt.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::ScrubBar</name>
    <message>
        <source>May have leaked after %1</source>
        <translation>Kann ausgelaufen sein nach %1</translation>
    </message>
</context>
<context>
    <name>vs::desktop::SeedTool</name>
    <message>
        <source>Draw on the segment: it is absorbed from there outward until you pause.</source>
        <translation>Auf das Segment zeichnen: es wird von dort nach außen absorbiert, bis zur Pause.</translation>
    </message>
    <message>
        <source>Draw on the segment: it is absorbed there; Step and Play go on outward.</source>
        <translation>Auf das Segment zeichnen: es wird dort absorbiert; Schritt und Abspielen gehen nach außen weiter.</translation>
    </message>
    <message>
        <source>R seeds again.</source>
        <translation>R sät wieder.</translation>
    </message>
    <message>
        <source>Draw on what should be segmented: it grows from there.</source>
        <translation>Auf das zeichnen, was segmentiert werden soll: es wächst von dort.</translation>
    </message>
    <message>
        <source>Draw on what should be segmented, then press Play.</source>
        <translation>Auf das zeichnen, was segmentiert werden soll, dann Abspielen drücken.</translation>
    </message>
    <message>
        <source>More strokes add to it.</source>
        <translation>Weitere Striche kommen hinzu.</translation>
    </message>
</context>
<context>
    <name>vs::desktop::SegmentChecks</name>
    <message>
        <source>All segments</source>
        <translation>Alle Segmente</translation>
    </message>
    <message>
        <source>All of them, or none</source>
        <translation>Alle oder keines</translation>
    </message>
    <message>
        <source>Segments to export</source>
        <translation>Segmente zum Exportieren</translation>
    </message>
</context>
<context>
    <name>vs::desktop::SegmentController</name>
    <message>
        <source>Segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>A segment&apos;s name has at most %1 characters</source>
        <translation>Der Name eines Segments hat höchstens %1 Zeichen</translation>
    </message>
    <message>
        <source>A segment needs a name</source>
        <translation>Ein Segment braucht einen Namen</translation>
    </message>
    <message>
        <source>There is a segment &apos;%1&apos; already; choose another name</source>
        <translation>Es gibt schon ein Segment „%1“; einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Arbeitet…</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Liest %1</translation>
    </message>
    <message>
        <source>The label map was dropped: its volume is no longer open</source>
        <translation>Die Labelkarte wurde verworfen: ihr Volumen ist nicht mehr offen</translation>
    </message>
</context>
<context>
    <name>vs::desktop::SegmentEditPanel</name>
    <message>
        <source>Edit segment</source>
        <translation>Segment bearbeiten</translation>
    </message>
    <message>
        <source>What to do with the segment at work</source>
        <translation>Was mit dem aktiven Segment geschehen soll</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>By how much</source>
        <translation>Um wie viel</translation>
    </message>
    <message>
        <source>The other segment</source>
        <translation>Das andere Segment</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Anderes</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Click in the picture</source>
        <translation>Ins Bild klicken</translation>
    </message>
</context>
<context>
    <name>vs::desktop::SegmentModel</name>
    <message>
        <source>Colour of %1: click to choose another</source>
        <translation>Farbe von %1: Klicken wählt eine andere</translation>
    </message>
    <message>
        <source>New strokes go to the segment that is marked; double-click or F2 to rename it</source>
        <translation>Neue Striche gehen zum markierten Segment; Doppelklick oder F2 benennt es um</translation>
    </message>
    <message>
        <source>What is shown of it now</source>
        <translation>Was gerade davon zu sehen ist</translation>
    </message>
    <message>
        <source>Seen: click to hide it</source>
        <translation>Sichtbar: Klicken verbirgt es</translation>
    </message>
    <message>
        <source>Hidden: click to show it</source>
        <translation>Verborgen: Klicken zeigt es</translation>
    </message>
    <message>
        <source>Locked: no tool changes it, nor cuts it</source>
        <translation>Gesperrt: kein Werkzeug ändert oder schneidet es</translation>
    </message>
    <message>
        <source>Click to lock it</source>
        <translation>Klicken sperrt es</translation>
    </message>
    <message>
        <source>Click to sort by it, the other way round, and as they were made</source>
        <translation>Klick sortiert danach, dann umgekehrt, dann in der Reihenfolge ihrer Entstehung</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Tools spare it: click to lock it</source>
        <translation>Werkzeuge verschonen es: Klick sperrt es</translation>
    </message>
    <message>
        <source>Tools take only this: click to lock it</source>
        <translation>Werkzeuge nehmen nur dieses: Klick sperrt es</translation>
    </message>
</context>
<context>
    <name>vs::desktop::SegmentNumbersPanel</name>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Mean, spread</source>
        <translation>Mittel, Streuung</translation>
    </message>
    <message>
        <source>Least, median, most</source>
        <translation>Min., Median, Max.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Copy all as CSV</source>
        <translation>Alles als CSV kopieren</translation>
    </message>
    <message>
        <source>Copy the numbers as CSV</source>
        <translation>Die Zahlen als CSV kopieren</translation>
    </message>
    <message>
        <source>The numbers of all segments, for a table, as `vstudio stats --csv` writes them</source>
        <translation>Die Zahlen aller Segmente für eine Tabelle, wie `vstudio stats --csv` sie schreibt</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>measuring…</source>
        <translation>misst…</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>Copied the numbers of one segment</source>
        <translation>Zahlen eines Segments kopiert</translation>
    </message>
    <message>
        <source>Copied the numbers of %1 segments</source>
        <translation>Zahlen von %1 Segmenten kopiert</translation>
    </message>
    <message>
        <source>Sphericity</source>
        <translation>Kugelförmigkeit</translation>
    </message>
    <message>
        <source>The surface of a ball of the same volume by this one: 1 for a ball</source>
        <translation>Die Oberfläche einer Kugel mit demselben Volumen, geteilt durch diese: 1 bei einer Kugel</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Of the ellipsoid with the same moments, the longest first</source>
        <translation>Die des Ellipsoids mit denselben Momenten, die längste zuerst</translation>
    </message>
    <message>
        <source>Parts, tunnels, cavities</source>
        <translation>Teile, Tunnel, Hohlräume</translation>
    </message>
    <message>
        <source>Pieces that do not touch, ways through as in a ring, hollows that are closed</source>
        <translation>Stücke, die einander nicht berühren, Durchgänge wie in einem Ring, geschlossene Hohlräume</translation>
    </message>
    <message>
        <source>Euler number</source>
        <translation>Eulerzahl</translation>
    </message>
    <message>
        <source>Parts less tunnels and more cavities</source>
        <translation>Teile minus Tunnel plus Hohlräume</translation>
    </message>
</context>
<context>
    <name>vs::desktop::SegmentTable</name>
    <message>
        <source>Colour of %1</source>
        <translation>Farbe von %1</translation>
    </message>
    <message>
        <source>Show only this</source>
        <translation>Nur dieses zeigen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Tools take it like all else</source>
        <translation>Werkzeuge nehmen es wie alles andere</translation>
    </message>
    <message>
        <source>Tools spare it</source>
        <translation>Werkzeuge verschonen es</translation>
    </message>
    <message>
        <source>Tools take only this</source>
        <translation>Werkzeuge nehmen nur dieses</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Zurücklegen</translation>
    </message>
    <message>
        <source>Pull out</source>
        <translation>Herausziehen</translation>
    </message>
</context>
<context>
    <name>vs::desktop::SeriesDialog</name>
    <message>
        <source>Series</source>
        <translation>Serien</translation>
    </message>
    <message>
        <source>Which series?</source>
        <translation>Welche Serie?</translation>
    </message>
    <message>
        <source>%1 holds %2 series. Open which?</source>
        <translation>%1 enthält %2 Serien. Welche öffnen?</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>(no description)</source>
        <translation>(keine Beschreibung)</translation>
    </message>
</context>
<context>
    <name>vs::desktop::ShapePage</name>
    <message>
        <source>Colours over intensity and gradient magnitude</source>
        <translation>Farben über Intensität und Gradientenbetrag</translation>
    </message>
    <message>
        <source>Drag on empty ground: a new shape. Drag a shape, or its corners. Double click: its colour. Right button: remove; while painting: erase.
Tab: the next shape; arrow keys move it; Delete; Return: its colour; Ctrl+Z. Wheel: closer.</source>
        <translation>Auf leerem Grund ziehen: eine neue Form. Form oder ihre Ecken ziehen. Doppelklick: ihre Farbe. Rechte Taste: entfernen; beim Malen: radieren.
Tab: die nächste Form; Pfeiltasten bewegen sie; Entf; Eingabe: ihre Farbe; Strg+Z. Rad: näher.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>New shapes are boxes</source>
        <translation>Neue Formen sind Kästen</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>New shapes stand on a point</source>
        <translation>Neue Formen stehen auf einer Spitze</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Paint free-hand; the right button erases</source>
        <translation>Freihand malen; die rechte Taste radiert</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>At its top</source>
        <translation>An ihrer Spitze</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>Size of the brush, in pixels</source>
        <translation>Größe des Pinsels, in Pixeln</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>%1: lower end</source>
        <translation>%1: unteres Ende</translation>
    </message>
    <message>
        <source>%1: upper end</source>
        <translation>%1: oberes Ende</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>The ends are exchanged: the lower one comes first.</source>
        <translation>Die Enden sind vertauscht: das untere kommt zuerst.</translation>
    </message>
    <message>
        <source>Counting…</source>
        <translation>Wird gezählt…</translation>
    </message>
</context>
<context>
    <name>vs::desktop::ShortcutSheet</name>
    <message>
        <source>Elsewhere</source>
        <translation>Sonst</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
</context>
<context>
    <name>vs::desktop::SliceCanvas</name>
    <message>
        <source>Windows of slices</source>
        <translation>Fenster der Schichten</translation>
    </message>
    <message>
        <source>L %1  W %2</source>
        <translation>L %1  W %2</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>interpoliert</translation>
    </message>
</context>
<context>
    <name>vs::desktop::SliceWidget</name>
    <message>
        <source>%1 slice</source>
        <translation>%1e Schicht</translation>
    </message>
    <message>
        <source>Where the %1 slice lies</source>
        <translation>Lage der Schicht: %1</translation>
    </message>
    <message>
        <source>Enlarge</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Make this slice large, or all the same size again (double click)</source>
        <translation>Diese Schicht groß, oder wieder alle gleich groß (Doppelklick)</translation>
    </message>
</context>
<context>
    <name>vs::desktop::StartCard</name>
    <message>
        <source>not found in %1</source>
        <translation>nicht gefunden in %1</translation>
    </message>
    <message>
        <source>There is no such file any more</source>
        <translation>Diese Datei gibt es nicht mehr</translation>
    </message>
    <message>
        <source>Has segments</source>
        <translation>Hat Segmente</translation>
    </message>
    <message>
        <source>A raw scan, without segments</source>
        <translation>Ein roher Scan, ohne Segmente</translation>
    </message>
    <message>
        <source>Forget %1</source>
        <translation>%1 vergessen</translation>
    </message>
    <message>
        <source>Take it off this list (Delete)</source>
        <translation>Von dieser Liste nehmen (Entf)</translation>
    </message>
    <message>
        <source>Comes with the program, and is played step by step</source>
        <translation>Gehört zum Programm und wird Schritt für Schritt abgespielt</translation>
    </message>
</context>
<context>
    <name>vs::desktop::StudioController</name>
    <message>
        <source>Finishing the picture</source>
        <translation>Das Bild wird fertig</translation>
    </message>
    <message>
        <source>Saved picture %1</source>
        <translation>Bild %1 gespeichert</translation>
    </message>
    <message>
        <source>Pictures are written as PNG: choose a name that ends in .png</source>
        <translation>Bilder werden als PNG geschrieben: einen Namen wählen, der auf .png endet</translation>
    </message>
</context>
<context>
    <name>vs::desktop::SweepTool</name>
    <message>
        <source>Draw the way that the shape goes. Esc clears it for a new shape.</source>
        <translation>Den Weg der Form zeichnen. Esc löscht sie für eine neue Form.</translation>
    </message>
    <message>
        <source>Nothing is under the shape, so the way cannot begin there. Esc clears it.</source>
        <translation>Unter der Form liegt nichts, also kann der Weg dort nicht beginnen. Esc löscht sie.</translation>
    </message>
    <message>
        <source>Let go where the way ends. Esc drops it.</source>
        <translation>Loslassen, wo der Weg endet. Esc verwirft ihn.</translation>
    </message>
    <message>
        <source>Enter restores what is shown. </source>
        <translation>Eingabe füllt Gezeigtes auf. </translation>
    </message>
    <message>
        <source>Enter cuts what is shown. </source>
        <translation>Eingabe schneidet Gezeigtes. </translation>
    </message>
    <message>
        <source>Draw again for another way. Esc drops it.</source>
        <translation>Neu zeichnen für einen anderen Weg. Esc verwirft ihn.</translation>
    </message>
    <message>
        <source>Draw again for another shape. Esc drops it.</source>
        <translation>Neu zeichnen für eine andere Form. Esc verwirft sie.</translation>
    </message>
    <message>
        <source>The way leads nowhere: draw it on the object, or longer</source>
        <translation>Der Weg führt nirgendwohin: auf dem Objekt zeichnen, oder länger</translation>
    </message>
    <message>
        <source>Draw the shape that is to be swept.</source>
        <translation>Die Form zeichnen, die ausgetragen werden soll.</translation>
    </message>
    <message>
        <source>Let go where the way ends: what it covers is put back. Esc drops it.</source>
        <translation>Am Ende des Weges loslassen: was er überdeckt, wird aufgefüllt. Esc verwirft ihn.</translation>
    </message>
    <message>
        <source>Let go where the way ends: what it covers is cut. Esc drops it.</source>
        <translation>Am Ende des Weges loslassen: was er überdeckt, wird geschnitten. Esc verwirft ihn.</translation>
    </message>
    <message>
        <source>Click the next corner. Enter or a double click ends the way, Esc drops it.</source>
        <translation>Die nächste Ecke anklicken. Eingabe oder ein Doppelklick beendet den Weg, Esc verwirft ihn.</translation>
    </message>
    <message>
        <source>Click the corners of the way that the shape goes. Esc clears it for a new shape.</source>
        <translation>Die Ecken des Wegs anklicken, den die Form nimmt. Esc verwirft sie für eine neue Form.</translation>
    </message>
    <message>
        <source>Enter takes material away from what is shown. </source>
        <translation>Eingabe nimmt Material aus dem Gezeigten weg. </translation>
    </message>
    <message>
        <source>Enter fills what is shown. </source>
        <translation>Eingabe füllt das Gezeigte. </translation>
    </message>
</context>
<context>
    <name>vs::desktop::ThumbnailKeeper</name>
    <message>
        <source>%1 × %2 × %3</source>
        <translation>%1 × %2 × %3</translation>
    </message>
</context>
<context>
    <name>vs::desktop::ToolPanel</name>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>%1: restore</source>
        <translation>%1: auffüllen</translation>
    </message>
    <message>
        <source>%1: add to the segment</source>
        <translation>%1: zum Segment</translation>
    </message>
    <message>
        <source>%1: remove from the segment</source>
        <translation>%1: aus dem Segment</translation>
    </message>
    <message>
        <source>The steps of the session are below the picture.</source>
        <translation>Die Schritte der Sitzung stehen unter dem Bild.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>%1: take material away</source>
        <translation>%1: Material wegnehmen</translation>
    </message>
    <message>
        <source>%1: fill</source>
        <translation>%1: füllen</translation>
    </message>
</context>
<context>
    <name>vs::desktop::ViewWidget</name>
    <message>
        <source>Picture of the volume</source>
        <translation>Bild des Volumens</translation>
    </message>
</context>
<context>
    <name>vs::desktop::WelcomePage</name>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Examples on this machine</source>
        <translation>Beispiele auf diesem Rechner</translation>
    </message>
    <message>
        <source>Volume Studio</source>
        <translation>Volume Studio</translation>
    </message>
    <message>
        <source>Reshape a 3D scan with your pen: peel it, drill it, and let what you mark grow.</source>
        <translation>Einen 3D-Scan mit dem Stift umformen: schälen, bohren, und Markiertes wachsen lassen.</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Datei öffnen…</translation>
    </message>
    <message>
        <source>Open a file</source>
        <translation>Datei öffnen</translation>
    </message>
    <message>
        <source>Open a DICOM folder…</source>
        <translation>DICOM-Ordner öffnen…</translation>
    </message>
    <message>
        <source>Open a DICOM folder</source>
        <translation>DICOM-Ordner öffnen</translation>
    </message>
    <message>
        <source>or drop a file or a folder anywhere in this window
DICOM · NIfTI · NRRD · MetaImage · VTK · raw · sessions</source>
        <translation>oder eine Datei oder einen Ordner irgendwo in dieses Fenster ziehen
DICOM · NIfTI · NRRD · MetaImage · VTK · roh · Sitzungen</translation>
    </message>
    <message>
        <source>Sculpt from nothing…</source>
        <translation>Aus dem Nichts formen…</translation>
    </message>
    <message>
        <source>Sculpt from nothing</source>
        <translation>Aus dem Nichts formen</translation>
    </message>
    <message>
        <source>Cases, played step by step</source>
        <translation>Fälle, Schritt für Schritt abgespielt</translation>
    </message>
</context>
</TS>
