package cz.paprsek.xml;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** Ways in which a scene file can be damaged; the same seed damages a file in the same way. */
enum Damage {
    FLIPPED_BITS {
        @Override
        byte[] apply(byte[] file, Random random) {
            byte[] bad = file.clone();
            for (int i = random.nextInt(4); i >= 0; i--) {
                bad[random.nextInt(bad.length)] ^= (byte) (1 << random.nextInt(8));
            }
            return bad;
        }
    },
    CUT {
        @Override
        byte[] apply(byte[] file, Random random) {
            return Arrays.copyOf(file, random.nextInt(file.length));
        }
    },
    HOLE {
        @Override
        byte[] apply(byte[] file, Random random) {
            int from = random.nextInt(file.length);
            int to = Math.min(file.length, from + 1 + random.nextInt(60));
            return joined(Arrays.copyOf(file, from), Arrays.copyOfRange(file, to, file.length));
        }
    },
    REPEATED_BLOCK {
        @Override
        byte[] apply(byte[] file, Random random) {
            int from = random.nextInt(file.length);
            int to = from + random.nextInt(Math.min(400, file.length - from) + 1);
            byte[] block = Arrays.copyOfRange(file, from, to);
            int at = random.nextInt(file.length);
            byte[] bad = Arrays.copyOf(file, at);
            for (int i = random.nextInt(20); i >= 0; i--) {
                bad = joined(bad, block);
            }
            return joined(bad, Arrays.copyOfRange(file, at, file.length));
        }
    },
    NULS {
        @Override
        byte[] apply(byte[] file, Random random) {
            byte[] bad = file.clone();
            int from = random.nextInt(bad.length);
            Arrays.fill(bad, from, Math.min(bad.length, from + 1 + random.nextInt(20)), (byte) 0);
            return bad;
        }
    },
    OTHER_NUMBER {
        @Override
        byte[] apply(byte[] file, Random random) {
            return replaced(file, NUMBER, NUMBERS.get(random.nextInt(NUMBERS.size())), random);
        }
    },
    SWAPPED_TAGS {
        @Override
        byte[] apply(byte[] file, Random random) {
            List<String> tags = Pattern.compile(TAG).matcher(text(file)).results().map(MatchResult::group).toList();
            return tags.isEmpty() ? file : replaced(file, TAG, tags.get(random.nextInt(tags.size())), random);
        }
    },
    OTHER_WORD {
        @Override
        byte[] apply(byte[] file, Random random) {
            return replaced(file, WORD, WORDS.get(random.nextInt(WORDS.size())), random);
        }
    },
    OTHER_ENCODING {
        @Override
        byte[] apply(byte[] file, Random random) {
            Charset charset = CHARSETS.get(random.nextInt(CHARSETS.size()));
            String text = text(file);
            return (random.nextBoolean() ? text.replace("UTF-8", charset.name()) : text.replace("ball", "koule ěščř 球")).getBytes(charset);
        }
    };

    private static final String NUMBER = "-?[0-9]+(\\.[0-9]+)?";
    private static final String TAG = "<[^>]*>";
    private static final String WORD = "[a-z][a-z-]+";
    private static final List<String> NUMBERS = List.of("1e999", "-1e999", "NaN", "INF", "-0", "1e-400", "99999999999999999999", "-1", "0", "1,5", "0x10",
            "1e308", "4.9e-324", "1".repeat(5000), "1 2", "", "2147483648", "1e45", "1e-45");
    private static final List<String> WORDS = List.of("sphere", "union", "scene", "database", "material", "xmlns", "xi:include", "xml", "checkerboard", "rectangle",
            "a".repeat(3000), "\u202E", "&amp;", "&lt;", "&#0;", "&#27;", "&x;", "]]>", "<!--", "<![CDATA[", "<?xml?>", "<!DOCTYPE a>", "\"", "'");
    private static final List<Charset> CHARSETS = List.of(StandardCharsets.UTF_16, StandardCharsets.UTF_16LE, StandardCharsets.UTF_16BE,
            StandardCharsets.ISO_8859_1, StandardCharsets.US_ASCII, Charset.forName("UTF-32"), Charset.forName("windows-1250"));

    /** A damaged copy of a file. */
    abstract byte[] apply(byte[] file, Random random);

    static String text(byte[] file) {
        return new String(file, StandardCharsets.UTF_8);
    }

    private static byte[] replaced(byte[] file, String pattern, String by, Random random) {
        String text = text(file);
        List<MatchResult> places = Pattern.compile(pattern).matcher(text).results().toList();
        if (places.isEmpty()) {
            return file;
        }
        MatchResult place = places.get(random.nextInt(places.size()));
        return (text.substring(0, place.start()) + by + text.substring(place.end())).getBytes(StandardCharsets.UTF_8);
    }

    private static byte[] joined(byte[] a, byte[] b) {
        byte[] both = Arrays.copyOf(a, a.length + b.length);
        System.arraycopy(b, 0, both, a.length, b.length);
        return both;
    }
}
