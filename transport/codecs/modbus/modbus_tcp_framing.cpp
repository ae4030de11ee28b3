#include "modbus_tcp_framing.h"

#include <QtEndian>

namespace lds::modbus {

TcpHeader decodeHeader(const QByteArray& bytes)
{
    Q_ASSERT(bytes.size() >= headerSize);
    const char* data = bytes.constData();
    return TcpHeader{qFromBigEndian<quint16>(data), qFromBigEndian<quint16>(data + 2),
                     qFromBigEndian<quint16>(data + 4), quint8(data[6])};
}

QByteArray encodeFrame(quint16 transaction, quint8 unit, const QByteArray& pdu)
{
    QByteArray frame(headerSize, '\0');
    qToBigEndian<quint16>(transaction, frame.data());
    qToBigEndian<quint16>(quint16(1 + pdu.size()), frame.data() + 4);
    frame[6] = char(unit);
    return frame + pdu;
}

} // namespace lds::modbus
