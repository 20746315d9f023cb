/**
 * Reads any file, however strange, and tells all that is wrong with it: parser, schema, and binding by JAXB to annotated beans, which do not leave
 * the package. The only one that needs JAXB.
 */
@XmlSchema(namespace = SceneFormat.NAMESPACE, elementFormDefault = XmlNsForm.QUALIFIED)
package cz.paprsek.xml.bind;

import cz.paprsek.xml.format.SceneFormat;
import jakarta.xml.bind.annotation.XmlNsForm;
import jakarta.xml.bind.annotation.XmlSchema;
