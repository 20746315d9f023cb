/**
 * The scene file: reading, with every problem told by line and column, and writing. {@link cz.paprsek.xml.SceneFiles} is the only door; the
 * annotated beans that files are bound to do not leave the package.
 */
@XmlSchema(namespace = SceneFiles.NAMESPACE, elementFormDefault = XmlNsForm.QUALIFIED)
package cz.paprsek.xml;

import jakarta.xml.bind.annotation.XmlNsForm;
import jakarta.xml.bind.annotation.XmlSchema;
